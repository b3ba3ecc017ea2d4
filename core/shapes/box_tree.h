// BoxTree: boxes in a tree of eight children a node, walked along a line from near to far. Formulas
// keep in it where their surface may be (field_cells.h, patches.h).
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/math/lanes.h"
#include "core/shapes/crossing.h"

namespace tia {

/// BoxTree. Space/units: floats around `middle`, so that small boxes far from the origin of space
/// keep their size; lines are tried on them in float, so boxes must be larger than what they hold
/// by 2^-20 of the whole tree.
struct BoxTree {
  static constexpr std::int32_t nothing = std::numeric_limits<std::int32_t>::min();
  struct Node {
    std::array<std::array<float, 8>, 3> low, high;  ///< by axis; low above high: no child
    std::array<std::int32_t, 8> child;              ///< a node, or ~leaf, or nothing
    Node();
    void set(std::size_t i, const Aabb& around_middle, std::int32_t what);
  };
  std::vector<Node> nodes;  ///< the first is the root; none: no boxes
  Vec3d middle{};
};

namespace detail {

// What the making of a tree may take: the cost of all evaluations, each of eight pieces at once,
// and levels, each of which halves three times.
inline constexpr double most_tree_cost = 4e6;
inline constexpr int most_tree_levels = 10;
// A piece is flat enough, and parted no more, where its slopes differ from the middle ones by no
// more than this part of them.
inline constexpr double flat_enough = 0.2;

/// Eight floats that are computed together, however many registers that takes.
using EightFloats = Registers<FloatRegister, 8 / FloatRegister::size>;
[[gnu::always_inline]] inline EightFloats lesser_of(const EightFloats& a, const EightFloats& b) {
  return EightFloats::map([](const auto& x, const auto& y) { return min_of(x, y); }, a, b);
}
[[gnu::always_inline]] inline EightFloats greater_of(const EightFloats& a, const EightFloats& b) {
  return EightFloats::map([](const auto& x, const auto& y) { return max_of(x, y); }, a, b);
}

template <class Mask>
unsigned bits_of(const Mask& mask) {
  unsigned all = 0;
  for (std::size_t i = 0; i < 8 / FloatRegister::size; ++i)
    all |= bits(mask.part[i]) << i * FloatRegister::size;
  return all;
}

float rounded_down(double x);
float rounded_up(double x);

/// A line as boxes are tried on it, around the tree's middle.
struct BoxLine {
  std::array<float, 3> origin, inverse;

  BoxLine(const Line& line, const Vec3d& middle);
};
/// Where the line is in each of a node's boxes. Returns: those that it meets, as bits.
/// Source: Kay, Kajiya, "Ray Tracing Complex Scenes", SIGGRAPH 1986: slabs.
inline unsigned stretches(const BoxTree::Node& node, const BoxLine& line, float from, float to,
                          std::array<float, 8>& in, std::array<float, 8>& out) {
  EightFloats first(from), last(to);
  unsigned met = 0xFF;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const EightFloats low = EightFloats::load_unaligned(node.low[axis].data());
    const EightFloats high = EightFloats::load_unaligned(node.high[axis].data());
    const EightFloats o(line.origin[axis]), d(line.inverse[axis]);
    if (!std::isfinite(line.inverse[axis])) {
      // It does not move there: 0 * infinity, in a face, would be no number.
      met &= bits_of(low <= o) & bits_of(o <= high);
      continue;
    }
    const EightFloats one = (low - o) * d, other = (high - o) * d;
    first = greater_of(lesser_of(one, other), first);
    last = lesser_of(greater_of(one, other), last);
  }
  first.store_unaligned(in.data());
  last.store_unaligned(out.data());
  return met & bits_of(first <= last);
}

}  // namespace detail

/// Calls visit(leaf, in, out) for each leaf whose box the line meets between `from` and `to`, with
/// its stretch there, siblings in the order in which they are entered. Boxes that do not overlap
/// come in that order altogether. Where visit returns a number, nothing beyond it is visited.
/// Returns: how many nodes were tried.
template <class Visit>
std::int64_t walk(const BoxTree& tree, const Line& line, double from, double to, Visit visit) {
  if (tree.nodes.empty()) return 0;
  struct Waiting {
    std::int32_t child;
    float in, out;
  };
  // At most seven wait a level, below 32 levels.
  std::array<Waiting, 7 * 32 + 8> waiting;
  std::size_t count = 0;
  std::int64_t tried = 0;
  const detail::BoxLine own_line(line, tree.middle);
  const float first_t = detail::rounded_down(from);
  float last_t = detail::rounded_up(to);
  waiting[count++] = {0, first_t, last_t};
  while (count > 0) {
    const Waiting next = waiting[--count];
    if (!(next.in <= last_t)) continue;
    if (next.child < 0) {
      to = visit(~next.child, std::max(double(next.in), from), std::min(double(next.out), to), to);
      last_t = detail::rounded_up(to);
      continue;
    }
    ++tried;
    std::array<float, 8> in, out;
    const BoxTree::Node& node = tree.nodes[static_cast<std::size_t>(next.child)];
    const unsigned met = detail::stretches(node, own_line, first_t, last_t, in, out);
    const std::size_t first = count;
    for (unsigned left = met; left != 0; left &= left - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(left));
      if (node.child[i] == BoxTree::nothing) continue;
      const Waiting own{node.child[i], in[i], out[i]};
      // The farther ones below: an insertion into at most eight.
      std::size_t at = count++;
      for (; at > first && waiting[at - 1].in < own.in; --at) waiting[at] = waiting[at - 1];
      waiting[at] = own;
    }
  }
  return tried;
}

}  // namespace tia
