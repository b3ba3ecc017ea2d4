// Bounding volume hierarchy: a tree of boxes over numbered things, up to eight children a node. It
// knows boxes only; the things in them are known to the visitor alone.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "core/boxes/huge_pages.h"
#include "core/boxes/ray_interval.h"
#include "core/boxes/work_counter.h"

namespace tia {

/// BvhChild: a node's child, in one word: a node, or a leaf of up to 15 entries of `order`.
/// Domain: numbers below 2^28.
class BvhChild {
 public:
  BvhChild() = default;  // none yet
  static constexpr BvhChild node(std::uint32_t number) { return BvhChild(number << bits); }
  static constexpr BvhChild leaf(std::uint32_t first, std::uint32_t count) {
    return BvhChild(first << bits | count);
  }
  static constexpr BvhChild of_word(std::uint32_t word) { return BvhChild(word); }

  bool is_leaf() const { return count() != 0; }
  /// Of a node its number; of a leaf the first of its entries.
  std::uint32_t first() const { return word_ >> bits; }
  /// Of a leaf how many; of a node 0.
  std::uint32_t count() const { return word_ & ((1U << bits) - 1); }
  std::uint32_t word() const { return word_; }
  bool operator==(const BvhChild&) const = default;

 private:
  static constexpr int bits = 4;
  explicit constexpr BvhChild(std::uint32_t word) : word_(word) {}
  std::uint32_t word_;  // of a list on the stack, whatever is there
};

/// Bvh: the root first.
struct Bvh {
  static constexpr int deepest = 64;
  static constexpr std::uint32_t largest_leaf = 8;
  struct alignas(64) Node {
    BoxSet boxes;  ///< of the children
    std::array<BvhChild, BoxSet::size> children{};
  };
  static_assert(sizeof(Node) == 256);
  HugeVector<Node> nodes;
  HugeVector<std::uint32_t> order;  ///< the things' numbers, as the leaves list them
};

inline std::size_t heap_bytes(const Bvh& bvh) {
  return heap_bytes(bvh.nodes) + heap_bytes(bvh.order);
}

namespace detail {

/// Children still to be visited, the nearest on top.
class BvhStack {
 public:
  struct Child {
    BvhChild child;
    std::uint32_t parent, slot;  ///< its node, and which of its children
    float near;
  };

  /// Adds the children that are entered, at least one, but for the nearest. Returns: that one.
  Child push_others(const Bvh& bvh, std::uint32_t parent, unsigned entered,
                    const BoxSet::Floats& near) {
    const Bvh::Node& node = bvh.nodes[parent];
    const auto child = [&](unsigned i) -> Child { return {node.children[i], parent, i, near[i]}; };
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

/// Up to so many rays of a packet go on one by one. Measured: 2 to 5 are equally fast, more or
/// fewer are slower.
inline constexpr int few_lanes = 4;

/// Traverses the tree with a packet, roughly from near to far, and calls leaf(first, count, lanes)
/// for the entries of `order` in a leaf that lanes enter; t_max may shrink from within. Nodes that
/// no ray of the interval enters are left out at once; in the others only the lanes that enter them
/// go on. Where those are at most `few`, alone(node, lanes) has to trace them through the node one
/// by one, because a packet costs as much with few rays as with many. Source: Benthin, Wald, Woop,
/// Ernst, "Combining single and packet-ray tracing for arbitrary ray distributions on the Intel MIC
/// architecture" (2012).
template <class Real, class Leaf, class Alone>
void traverse(const Bvh& bvh, const BoxRay<Real>& ray, const RayInterval& interval,
              Mask<Real> active, const Real& t_max, WorkCounter& work, Leaf leaf, int few,
              Alone alone) {
  float furthest = greatest(t_max, active);
  detail::BvhStack stack;
  detail::BvhStack::Child next{};
  for (;;) {
    work.test();
    BoxSet::Floats near;
    const unsigned ahead = interval.enters(bvh.nodes[next.child.first()].boxes, furthest, near);
    if (ahead != 0) next = stack.push_others(bvh, next.child.first(), ahead, near);
    else if (!stack.pop(furthest, next)) return;
    for (;;) {
      Mask<Real> entered = active;
      if constexpr (lanes < Real >> 1) {  // for a single ray the test of the interval was exact
        work.test();
        entered = active && ray.enters(bvh.nodes[next.parent].boxes.box(next.slot), t_max);
      }
      if (any(entered)) {
        const BvhChild child = next.child;
        if (child.is_leaf()) leaf(child.first(), child.count(), entered);
        else if (few == 0 || count(entered) > few) break;
        else alone(child.first(), entered);
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
