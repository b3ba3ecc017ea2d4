// Bounding volume hierarchy: a binary tree of boxes over numbered things. It knows boxes only; what
// is in them is the visitor's business.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/accel/packet.h"

namespace tia {

/// Bvh: nodes in depth-first order; a node's first child follows it.
struct Bvh {
  static constexpr int deepest = 64;
  struct Node {
    Box32 box;
    std::uint32_t first =
        0;  ///< inner: the second child; leaf: the first of its entries of `order`
    std::uint16_t count = 0;  ///< leaf: how many; 0: an inner node
    std::uint16_t axis = 0;   ///< inner: the axis along which the children follow each other
  };
  static_assert(sizeof(Node) == 32);
  std::vector<Node> nodes;
  std::vector<std::uint32_t> order;  ///< the things' numbers, as the leaves list them
};

/// Binned surface area heuristic: of 16 bins along each axis of the centres the split with the
/// least expected cost; the middle of the list where no split separates anything.
/// Domain: boxes that are bounded and not empty. Cost: O(n log n).
/// Source: Wald, "On fast construction of SAH-based bounding volume hierarchies" (2007).
Bvh build_bvh(const std::vector<Aabb>& boxes);

/// Calls visit(number, lanes, alone) for each thing in a leaf whose box lanes of `active` enter
/// before t_max, roughly from near to far; alone: the leaf's box is the thing's own. t_max may
/// shrink from within.
template <class Real, class Visit>
void traverse(const Bvh& bvh, const BoxRay<Real>& ray, Mask<Real> active, const Real& t_max,
              std::int64_t& tests, Visit visit) {
  if (bvh.nodes.empty()) return;
  std::array<std::uint32_t, Bvh::deepest + 1> stack;
  std::size_t top = 0;
  stack[top++] = 0;
  while (top > 0) {
    const std::uint32_t at = stack[--top];
    const Bvh::Node& node = bvh.nodes[at];
    ++tests;
    const Mask<Real> entered = active && ray.enters(node.box, t_max);
    if (!any(entered)) continue;
    for (std::uint32_t i = 0; i < node.count; ++i)
      visit(bvh.order[node.first + i], entered, node.count == 1);
    if (node.count > 0) continue;
    const bool backwards = ray.backwards(node.axis);
    stack[top++] = backwards ? at + 1 : node.first;
    stack[top++] = backwards ? node.first : at + 1;
  }
}

}  // namespace tia
