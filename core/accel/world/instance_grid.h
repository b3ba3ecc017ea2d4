// InstanceGrid: a grid of instances of a space, and its traversal by rays, which computes the boxes
// of parts of the grid when they are needed and stores none.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "core/accel/world/packet.h"
#include "core/boxes/work_counter.h"
#include "core/shapes/composite/group.h"

namespace tia {

/// InstanceGrid. Space/units: `to_group` maps from the space that contains the group to the group's
/// own.
struct InstanceGrid {
  Affine to_group;
  Repeat repeat;
  Aabb box;         ///< of one instance
  int inside = 0;   ///< the space that is repeated
  int outside = 0;  ///< the space that contains the group
  float slack = 0;  ///< how much the boxes of instances are enlarged against rounding

  /// The slack of a grid whose instances together fill that box (tolerance::grid_box).
  static float slack_of(const Aabb& all);
  /// The position in the grid of the instance of that number; x varies fastest, then y.
  std::array<int, 3> place(std::int64_t number) const;
  /// Its offset from the first instance's place in the group's own space.
  Vec3d offset(std::int64_t number) const;
};

/// InstanceRange: part of a grid, the instances with from <= i < to along each axis.
struct InstanceRange {
  std::array<int, 3> from, to;

  int count(std::size_t axis) const { return to[axis] - from[axis]; }
  /// The axis along which the range is longest: count times step. It is divided there.
  std::size_t longest(const Vec3d& step) const;
  /// The box around the range's instances.
  Box32 box(const InstanceGrid& grid) const;
};

/// Calls visit(number, lanes) for each instance whose box lanes of `active` enter before t_max,
/// roughly from near to far. The grid is halved along its longest axis, again and again.
template <class Real, class Visit>
void traverse(const InstanceGrid& grid, const BoxRay<Real>& ray, Mask<Real> active,
              const Real& t_max, WorkCounter& work, Visit visit) {
  constexpr std::size_t deepest = std::size_t{3} * 25;  // halvings of three counts up to 2^24
  const Repeat& repeat = grid.repeat;
  const double steps[] = {repeat.step.x, repeat.step.y, repeat.step.z};
  std::array<InstanceRange, deepest + 1> stack;
  std::size_t top = 0;
  stack[top++] = {{0, 0, 0}, repeat.count};
  while (top > 0) {
    const InstanceRange range = stack[--top];
    work.test();
    const Mask<Real> entered = active && ray.enters(range.box(grid), t_max);
    if (!any(entered)) continue;
    const std::size_t axis = range.longest(repeat.step);
    if (range.count(axis) == 1) {
      const auto [i, j, k] = range.from;
      visit(i + repeat.count[0] * (j + repeat.count[1] * k), entered);
      continue;
    }
    InstanceRange near = range, far = range;
    near.to[axis] = far.from[axis] = range.from[axis] + range.count(axis) / 2;
    if (ray.backwards(static_cast<int>(axis)) != (steps[axis] < 0)) std::swap(near, far);
    stack[top++] = far;
    stack[top++] = near;
  }
}

}  // namespace tia
