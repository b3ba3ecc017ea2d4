// Bounding volume hierarchy: a tree of boxes over numbered things, up to eight children a node. It
// knows boxes only; the things in them are known to the visitor alone.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "core/boxes/huge_pages.h"
#include "core/boxes/lone_ray.h"
#include "core/boxes/ray_interval.h"
#include "core/boxes/work_counter.h"

namespace tia {

/// Bvh: the root first.
struct Bvh {
  static constexpr int deepest = 64;
  struct alignas(64) Node {
    BoxSet boxes;  ///< of the children
    /// Of a child that is a node its number; of a leaf the first of its entries of `order`.
    std::array<std::uint32_t, BoxSet::size> first{};
    std::array<std::uint16_t, BoxSet::size> count{};  ///< of a leaf how many; of a node 0
  };
  static_assert(sizeof(Node) == 256);
  using Nodes = std::vector<Node, HugePages<Node>>;
  Nodes nodes;
  std::vector<std::uint32_t> order;  ///< the things' numbers, as the leaves list them
};

inline std::size_t heap_bytes(const Bvh& bvh) {
  return heap_bytes(bvh.nodes) + heap_bytes(bvh.order);
}

namespace detail {

/// Children still to be visited, the nearest on top.
class BvhStack {
 public:
  struct Child {
    std::uint32_t first;        ///< as its node's
    std::uint16_t count, slot;  ///< as its node's, and which of its children
    std::uint32_t parent;       ///< its node
    float near;

    bool is_leaf() const { return count != 0; }
  };

  /// Adds the children that are entered, at least one, but for the nearest. Returns: that one.
  Child push_others(const Bvh& bvh, std::uint32_t parent, unsigned entered,
                    const BoxSet::Floats& near) {
    const Bvh::Node& node = bvh.nodes[parent];
    const auto child = [&](unsigned i) -> Child {
      return {node.first[i], node.count[i], static_cast<std::uint16_t>(i), parent, near[i]};
    };
    const unsigned others = entered & (entered - 1);
    // Mostly one or two are entered. Which, and which of them is nearer, could not be predicted, so
    // there are no branches.
    if ((others & (others - 1)) == 0) {
      const auto a = static_cast<unsigned>(std::countr_zero(entered));
      const auto b = 31 - static_cast<unsigned>(std::countl_zero(entered));
      const unsigned nearer = a ^ ((a ^ b) & (0U - static_cast<unsigned>(near[b] < near[a])));
      entries_[top_] = child(a ^ b ^ nearer);
      top_ += others != 0;
      return child(nearer);
    }
    const std::size_t bottom = top_;
    for (unsigned left = entered; left != 0; left &= left - 1) {
      const Child next = child(static_cast<unsigned>(std::countr_zero(left)));
      std::size_t at = top_++;
      for (; at > bottom && entries_[at - 1].near < next.near; --at)
        entries_[at] = entries_[at - 1];
      entries_[at] = next;
    }
    return entries_[--top_];
  }
  /// Takes the nearest one that begins before t_max. Returns: whether there was one.
  bool pop(float t_max, Child& child) {
    while (top_ > 0) {
      child = entries_[--top_];
      if (child.near <= t_max) return true;
    }
    return false;
  }

 private:
  std::array<Child, Bvh::deepest*(BoxSet::size - 1) + 1> entries_;
  std::size_t top_ = 0;
};

}  // namespace detail

/// What traverse calls for a leaf that lanes enter: leaf(first, count, lanes), entries of `order`.
/// t_max may shrink from within. All traversals go roughly from near to far.
///
/// One ray alone through the subtree of a node. Source: as LoneRay's.
template <class Leaf>
void traverse(const Bvh& bvh, std::uint32_t root, const LoneRay& ray, const float& t_max,
              WorkCounter& work, Leaf leaf) {
  detail::BvhStack stack;
  detail::BvhStack::Child next{root, 0, 0, 0, 0};
  for (;;) {
    work.test();
    BoxSet::Floats near;
    const unsigned entered = ray.enters(bvh.nodes[next.first].boxes, t_max, near);
    if (entered != 0) next = stack.push_others(bvh, next.first, entered, near);
    else if (!stack.pop(t_max, next)) return;
    while (next.is_leaf()) {
      leaf(next.first, next.count, true);
      if (!stack.pop(t_max, next)) return;
    }
  }
}

/// Up to so many rays of a packet go on one by one. Measured: 2 to 5 are equally fast, more or
/// fewer are slower.
inline constexpr int few_lanes = 4;

/// Traverses the tree with a packet. Nodes that no ray of the interval enters are left out at once;
/// in the others only the lanes that enter them go on. Where those are at most `few`, alone(node,
/// lanes) has to trace them through the node one by one, because a packet costs as much with few
/// rays as with many. Source: Benthin, Wald, Woop, Ernst, "Combining single and packet-ray tracing
/// for arbitrary ray distributions on the Intel MIC architecture" (2012).
template <class Real, class Leaf, class Alone>
void traverse(const Bvh& bvh, const BoxRay<Real>& ray, const RayInterval& interval,
              Mask<Real> active, const Real& t_max, WorkCounter& work, Leaf leaf, int few,
              Alone alone) {
  float furthest = greatest(t_max, active);
  detail::BvhStack stack;
  detail::BvhStack::Child next{0, 0, 0, 0, 0};
  for (;;) {
    work.test();
    BoxSet::Floats near;
    const unsigned ahead = interval.enters(bvh.nodes[next.first].boxes, furthest, near);
    if (ahead != 0) next = stack.push_others(bvh, next.first, ahead, near);
    else if (!stack.pop(furthest, next)) return;
    for (;;) {
      Mask<Real> entered = active;
      if constexpr (lanes < Real >> 1) {  // for a single ray the test of the interval was exact
        work.test();
        entered = active && ray.enters(bvh.nodes[next.parent].boxes.box(next.slot), t_max);
      }
      if (any(entered)) {
        if (next.is_leaf()) leaf(next.first, next.count, entered);
        else if (few == 0 || count(entered) > few) break;
        else alone(next.first, entered);
        furthest = greatest(t_max, active);
      }
      if (!stack.pop(furthest, next)) return;
    }
  }
}

/// The same, without going on one by one.
template <class Real, class Leaf>
void traverse(const Bvh& bvh, const BoxRay<Real>& ray, Mask<Real> active, const Real& t_max,
              WorkCounter& work, Leaf leaf) {
  if (bvh.nodes.empty()) return;
  traverse(bvh, ray, RayInterval(ray, active), active, t_max, work, leaf, 0,
           [](std::uint32_t, Mask<Real>) {});
}

}  // namespace tia
