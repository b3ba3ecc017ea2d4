// A line in double through a tree of boxes: from near to far, and where it is in each leaf's box.
#pragma once

#include <cmath>

#include "core/boxes/bvh.h"
#include "core/math/ray.h"

namespace tia {

/// OffsetBvh. Space/units: floats around `middle`, so that small boxes far from the origin of space
/// keep their size. Lines are tried on them in float, so boxes must be larger than what they
/// contain by tolerance::cell_box of the whole tree. A leaf is one thing, and `first` its number;
/// there is no `order`.
struct OffsetBvh : Bvh {
  Vec3d middle{};

  /// Adds a child to a node: a leaf, or a node further on. The box is around the middle.
  void add_leaf(std::size_t node, const Aabb& box, std::size_t number) {
    add(nodes[node], box, BvhChild::leaf(static_cast<std::uint32_t>(number), 1));
  }
  void add_node(std::size_t node, const Aabb& box, std::size_t child) {
    add(nodes[node], box, BvhChild::node(static_cast<std::uint32_t>(child)));
  }

 private:
  static void add(Node& node, const Aabb& box, BvhChild child) {
    node.children[node.boxes.count] = child;
    node.boxes.add(enclosing(box));
  }
};

namespace detail {

/// A line as boxes are tried on it, around the tree's middle.
struct BoxLine {
  std::array<float, 3> origin, inverse;

  BoxLine(const Ray<double>& line, const Vec3d& middle) {
    const Vec3d o = line.origin - middle, &d = line.direction;
    origin = {static_cast<float>(o.x), static_cast<float>(o.y), static_cast<float>(o.z)};
    inverse = {static_cast<float>(1 / d.x), static_cast<float>(1 / d.y),
               static_cast<float>(1 / d.z)};
  }
};

/// Where the line is in each of the boxes. Returns: those that it meets, as bits.
/// Source: Kay, Kajiya, "Ray Tracing Complex Scenes", SIGGRAPH 1986: slabs.
inline unsigned stretches(const BoxSet& boxes, const BoxLine& line, float from, float to,
                          BoxSet::Floats& in, BoxSet::Floats& out) {
  Eight first(from), last(to);
  unsigned met = 0xFF;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Eight low = Eight::load_unaligned(boxes.face(axis)),
                high = Eight::load_unaligned(boxes.face(axis + 3));
    const Eight o(line.origin[axis]), d(line.inverse[axis]);
    if (!std::isfinite(line.inverse[axis])) {
      // The line is parallel to these faces; in one of them the product would be 0 * infinity.
      met &= at_most(low, o, boxes) & at_most(o, high, boxes);
      continue;
    }
    const Eight one = (low - o) * d, other = (high - o) * d;
    first = greatest_of(least_of(one, other), first);
    last = least_of(greatest_of(one, other), last);
  }
  first.store_unaligned(in.data());
  last.store_unaligned(out.data());
  return met & at_most(first, last, boxes);
}

}  // namespace detail

/// Calls visit(leaf, in, out, to) for each leaf whose box the line meets between `from` and `to`,
/// with its stretch there, siblings in the order in which they are entered. Boxes that do not
/// overlap come in that order altogether. What visit returns is the new `to`, beyond which nothing
/// is visited. Domain: a tree of at most 32 levels.
/// Returns: how many nodes were tried.
template <class Visit>
std::int64_t traverse(const OffsetBvh& tree, const Ray<double>& line, double from, double to,
                      Visit visit) {
  if (tree.nodes.empty()) return 0;
  struct Waiting {
    BvhChild child;
    float in, out;
  };
  // At most seven wait a level.
  std::array<Waiting, 7 * 32 + 8> waiting;
  std::size_t count = 0;
  std::int64_t tried = 0;
  const detail::BoxLine own_line(line, tree.middle);
  const float first_t = rounded_down(from);
  float last_t = rounded_up(to);
  waiting[count++] = {{}, first_t, last_t};
  while (count > 0) {
    const Waiting next = waiting[--count];
    if (!(next.in <= last_t)) continue;
    if (next.child.is_leaf()) {
      to = visit(next.child.first(), std::max(double(next.in), from),
                 std::min(double(next.out), to), to);
      last_t = rounded_up(to);
      continue;
    }
    ++tried;
    BoxSet::Floats in, out;
    const Bvh::Node& node = tree.nodes[next.child.first()];
    const unsigned met = detail::stretches(node.boxes, own_line, first_t, last_t, in, out);
    const std::size_t bottom = count;
    for (unsigned left = met; left != 0; left &= left - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(left));
      const Waiting own{node.children[i], in[i], out[i]};
      // The farther ones below: an insertion into at most eight.
      std::size_t at = count++;
      for (; at > bottom && waiting[at - 1].in < own.in; --at) waiting[at] = waiting[at - 1];
      waiting[at] = own;
    }
  }
  return tried;
}

}  // namespace tia
