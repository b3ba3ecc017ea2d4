// Single rays through a tree of boxes: one alone, or several by turns.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <utility>

#include "core/boxes/bvh.h"
#include "core/boxes/fixed_list.h"
#include "core/boxes/lone_ray.h"

namespace tia {
namespace detail {

/// LoneStack: children still to be visited by one ray, the nearest on top.
class LoneStack {
 public:
  /// Entry: where a child's box is entered, as a float's bits, above the child's word. As no
  /// distance is negative, the nearer one is the lesser number.
  using Entry = std::uint64_t;
  static BvhChild child_of(Entry entry) {
    return BvhChild::of_word(static_cast<std::uint32_t>(entry));
  }

  /// Adds the children that are entered, at least one, but for the nearest. Returns: that one.
  [[gnu::always_inline]] BvhChild push_others(const Bvh::Node& node, unsigned entered,
                                              const BoxSet::Floats& near) {
    const auto entry = [&](unsigned i) -> Entry {
      return Entry{std::bit_cast<std::uint32_t>(near[i])} << 32U | node.children[i].word();
    };
    const auto next = [&] {
      const auto i = static_cast<unsigned>(std::countr_zero(entered));
      entered &= entered - 1;
      return entry(i);
    };
    // Mostly one or two are entered. How many, and which of them is nearer, could not be predicted,
    // so there is no branch for that.
    Entry a = next();
    if ((entered & (entered - 1)) == 0) {
      const bool two = entered != 0;
      const unsigned last = 1U << (BoxSet::size - 1);  // instead of none, and then the farther one
      Entry b = entry(static_cast<unsigned>(std::countr_zero(entered | last)));
      b |= Entry{0} - static_cast<Entry>(!two);
      sort(a, b);
      entries_[top_] = b;
      top_ += two;
      return child_of(a);
    }
    Entry b = next(), c = next();
    sort(a, b), sort(b, c), sort(a, b);
    while (entered != 0) {
      Entry d = next();
      sort(a, d), sort(b, d), sort(c, d);
      entries_[top_++] = d;  // beyond the three nearest in any order
    }
    entries_[top_++] = c;
    entries_[top_++] = b;
    return child_of(a);
  }
  /// Takes the nearest one that is entered at `most`. Returns: whether there was one.
  [[gnu::always_inline]] bool pop(float most, BvhChild& child) {
    const auto limit = std::bit_cast<std::int32_t>(most);
    while (top_ > 0) {
      const Entry entry = entries_[--top_];
      child = child_of(entry);
      if (static_cast<std::int64_t>(entry >> 32U) <= limit) return true;
    }
    return false;
  }

 private:
  // Compilers make branches of std::min.
  static void sort(Entry& nearer, Entry& farther) {
    const Entry swapped = (nearer ^ farther) & (Entry{0} - static_cast<Entry>(farther < nearer));
    nearer ^= swapped;
    farther ^= swapped;
  }
  std::array<Entry, Bvh::deepest*(BoxSet::size - 1) + 1> entries_;
  std::size_t top_ = 0;
};

}  // namespace detail

/// One ray alone through the subtree of a node, as the packets' traverse (bvh.h). `leaf` counts its
/// tests itself.
/// Source: as LoneRay's.
template <bool exact, class Leaf>
void traverse(const Bvh& bvh, std::uint32_t root, const LoneRay<exact>& given, const float& t_max,
              WorkCounter& work, Leaf leaf) {
  detail::LoneStack stack;
  BvhChild next = BvhChild::node(root);
  const Bvh::Node* const nodes = bvh.nodes.data();
  for (;;) {
    // From node to node, with all that is needed in registers.
    const LoneRay<exact> ray = given;
    const float limit = LoneRay<exact>::limit(t_max);
    std::int64_t tests = 0;
    bool more = true;
    while (more && !next.is_leaf()) {
      ++tests;
      const Bvh::Node& node = nodes[next.first()];
      BoxSet::Floats near;
      const unsigned entered = ray.enters(node.boxes, limit, near);
      if (entered != 0) next = stack.push_others(node, entered, near);
      else more = stack.pop(limit, next);
    }
    work.tests(tests);
    if (!more) return;
    do {
      leaf(next.first(), next.count(), true);
      if (!stack.pop(LoneRay<exact>::limit(t_max), next)) return;
    } while (next.is_leaf());
  }
}

/// LoneTraversal: how far a ray has come that goes by turns with others.
template <bool exact>
struct LoneTraversal {
  LoneRay<exact> ray;
  std::size_t number;  ///< whose it is, for the caller
  float limit;         ///< LoneRay::limit of its t_max
  BvhChild next;       ///< what it visits next
  unsigned found = 0;  ///< by its last test: which children are entered, or what a leaf has told
  alignas(32) BoxSet::Floats near;  ///< where those children are entered
  detail::LoneStack stack;

  /// One of a packet's rays, up to t_max, before the subtree of a node.
  template <class Real>
  LoneTraversal(const BoxRay<Real>& rays, int lane, float t_max, std::uint32_t root,
                std::size_t own_number)
      : ray(rays, lane),
        number(own_number),
        limit(LoneRay<exact>::limit(t_max)),
        next(BvhChild::node(root)) {}
  /// Goes on from a node that has been tested. Returns: whether there is something to go on to.
  [[gnu::always_inline]] bool leave_node(const Bvh::Node& node) {
    if (found == 0) return stack.pop(limit, next);
    next = stack.push_others(node, found, near);
    return true;
  }
};

/// As many rays as may go by turns.
inline constexpr std::size_t most_lone_rays = static_cast<std::size_t>(lanes<Wide>);
template <bool exact>
using LoneTraversals = FixedList<LoneTraversal<exact>, most_lone_rays>;

/// Several rays, each alone through the subtree of its node, by turns. First all make a test, none
/// of which waits for another, then each goes where its test sends it, which no processor can
/// predict: what it has begun in vain is little then, for the tests are done.
/// Leaves has unsigned test(ray, first, count), without branches, whose answer, unless it is 0,
/// goes to float take(ray, first, count, answer), which returns the ray's t_max. Each counts as
/// one.
template <bool exact, class Leaves>
void traverse(const Bvh& bvh, std::span<LoneTraversal<exact>> rays, WorkCounter& work,
              Leaves leaves) {
  using Ray = LoneTraversal<exact>;
  const Bvh::Node* const nodes = bvh.nodes.data();
  // Who visits a node next, and who a leaf. Each ray is written to both lists, and the end of one
  // of them is moved: a branch could not be predicted.
  std::array<Ray*, most_lone_rays + 1> at_node, at_leaf;
  std::size_t node_count = 0, leaf_count = 0;
  const auto list = [&](Ray * ray, bool goes_on) __attribute__((always_inline)) {
    const bool is_leaf = ray->next.is_leaf();
    at_node[node_count] = at_leaf[leaf_count] = ray;
    node_count += goes_on & !is_leaf;
    leaf_count += goes_on & is_leaf;
  };
  for (Ray& ray : rays) list(&ray, true);
  while (node_count + leaf_count > 0) {
    const std::size_t of_nodes = std::exchange(node_count, 0);
    work.tests(static_cast<std::int64_t>(of_nodes));
    for (std::size_t k = 0; k < of_nodes; ++k) {
      Ray& ray = *at_node[k];
      ray.found = ray.ray.enters(nodes[ray.next.first()].boxes, ray.limit, ray.near);
    }
    for (std::size_t k = 0; k < of_nodes; ++k) {
      Ray* const ray = at_node[k];
      list(ray, ray->leave_node(nodes[ray->next.first()]));
    }
    const std::size_t of_leaves = std::exchange(leaf_count, 0);
    work.tests(static_cast<std::int64_t>(of_leaves));
    for (std::size_t k = 0; k < of_leaves; ++k) {
      Ray& ray = *at_leaf[k];
      ray.found = leaves.test(ray, ray.next.first(), ray.next.count());
    }
    for (std::size_t k = 0; k < of_leaves; ++k) {
      Ray* const ray = at_leaf[k];
      if (ray->found != 0)
        ray->limit = LoneRay<exact>::limit(
            leaves.take(*ray, ray->next.first(), ray->next.count(), ray->found));
      list(ray, ray->stack.pop(ray->limit, ray->next));
    }
  }
}

}  // namespace tia
