// InstanceGrid: a grid of instances of a space, and the way of rays through it: an index without
// memory.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "core/accel/world/packet.h"
#include "core/boxes/work_counter.h"
#include "core/shapes/composite/group.h"

namespace tia {

/// InstanceGrid. Space/units: `to_group` leads from the space where the group stands to its own.
struct InstanceGrid {
  Affine to_group;
  Repeat repeat;
  Aabb box;         ///< of one instance
  int inside = 0;   ///< the space that is repeated
  int outside = 0;  ///< the space where the group stands
  float slack = 0;  ///< by how much boxes of instances grow, so that float holds all of them

  /// Of instances that fill a box: beyond all roundings of their coordinates.
  static float slack_of(const Aabb& all);
  /// Which one along x, y and z the instance of that number is: x runs fastest, then y.
  std::array<int, 3> place(std::int64_t number) const;
  /// Where it stands.
  Vec3d offset(std::int64_t number) const;
};

/// InstanceRange: part of a grid, the instances with from <= i < to along each axis.
struct InstanceRange {
  std::array<int, 3> from, to;

  int count(std::size_t axis) const { return to[axis] - from[axis]; }
  /// The axis along which there are most, weighed by the step.
  std::size_t longest(const Vec3d& step) const;
  /// The box around the range's instances.
  Box32 box(const InstanceGrid& grid) const;
};

/// Calls visit(number, lanes) for each instance whose box lanes of `active` enter before t_max,
/// roughly from near to far, by halving the grid.
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
