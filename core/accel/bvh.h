// Bounding volume hierarchy: a tree of boxes over numbered things, up to eight children a node. It
// knows boxes only; what is in them is the visitor's business.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <stop_token>
#include <vector>

#include "core/accel/bundle.h"
#include "core/accel/effort.h"
#include "core/accel/packet.h"

namespace tia {

/// Bvh: the root first.
struct Bvh {
  static constexpr int deepest = 64;
  struct Node {
    BoxSet boxes;  ///< of the children
    /// Of a child that is a node its number; of a leaf the first of its entries of `order`.
    std::array<std::uint32_t, BoxSet::size> first{};
    std::array<std::uint16_t, BoxSet::size> count{};  ///< of a leaf how many; of a node 0
  };
  std::vector<Node> nodes;
  std::vector<std::uint32_t> order;  ///< the things' numbers, as the leaves list them
};

/// Binned surface area heuristic: of 16 bins along each axis of the centres the split with the
/// least expected cost; the middle of the list where no split separates anything.
/// Domain: boxes that are bounded and not empty. Cost: O(n log n). Errors: Stopped.
/// Source: Wald, "On fast construction of SAH-based bounding volume hierarchies" (2007); eight
/// children: Wald, Benthin, Boulos, "Getting rid of packets" (2008).
Bvh build_bvh(const std::vector<Aabb>& boxes, const std::stop_token& stop = {});

namespace detail {

/// Children still to be visited, the nearest on top.
struct BvhStack {
  struct Entry {
    const Bvh::Node* node;
    std::uint32_t child;
    float near;
  };
  std::array<Entry, Bvh::deepest*(BoxSet::size - 1) + 1> entries;
  std::size_t top = 0;

  /// Adds the children that rays of the bundle may enter before t_max.
  void push(const Bvh::Node& node, const Bundle& bundle, float t_max) {
    BoxSet::Floats near;
    const std::size_t bottom = top;
    for (unsigned left = bundle.enters(node.boxes, t_max, near); left != 0; left &= left - 1) {
      const auto child = static_cast<std::uint32_t>(std::countr_zero(left));
      std::size_t at = top++;
      for (; at > bottom && entries[at - 1].near < near[child]; --at) entries[at] = entries[at - 1];
      entries[at] = {&node, child, near[child]};
    }
  }
};

}  // namespace detail

/// Calls visit(number, lanes, alone) for each thing in a leaf whose box lanes of `active` enter
/// before t_max, roughly from near to far; alone: the leaf's box is the thing's own. t_max may
/// shrink from within.
template <class Real, class Visit>
void traverse(const Bvh& bvh, const BoxRay<Real>& ray, Mask<Real> active, const Real& t_max,
              Effort& effort, Visit visit) {
  if (bvh.nodes.empty()) return;
  const Bundle bundle(ray, active);
  float furthest = greatest(t_max, active);
  detail::BvhStack stack;
  const auto open = [&](const Bvh::Node& node) {
    effort.test();
    stack.push(node, bundle, furthest);
  };
  open(bvh.nodes.front());
  while (stack.top > 0) {
    const auto [node, child, near] = stack.entries[--stack.top];
    if (near > furthest) continue;
    Mask<Real> entered = active;
    if constexpr (lanes < Real >> 1) {  // of one ray the bundle has told all
      effort.test();
      entered = active && ray.enters(node->boxes.box(child), t_max);
      if (!any(entered)) continue;
    }
    const std::uint32_t first = node->first[child], count = node->count[child];
    if (count == 0) {
      open(bvh.nodes[first]);
      continue;
    }
    for (std::uint32_t i = 0; i < count; ++i) visit(bvh.order[first + i], entered, count == 1);
    furthest = greatest(t_max, active);
  }
}

}  // namespace tia
