#include "core/accel/world/instance_grid.h"

#include <algorithm>
#include <cmath>

#include "core/math/tolerances.h"

namespace tia {

std::array<int, 3> InstanceGrid::place(std::int64_t number) const {
  const std::int64_t nx = repeat.count[0], ny = repeat.count[1];
  return {static_cast<int>(number % nx), static_cast<int>(number / nx % ny),
          static_cast<int>(number / nx / ny)};
}

Vec3d InstanceGrid::offset(std::int64_t number) const {
  const auto [i, j, k] = place(number);
  return repeat.offset(i, j, k);
}

std::size_t InstanceRange::longest(const Vec3d& step) const {
  const std::array<double, 3> steps{step.x, step.y, step.z};
  std::size_t longest = 0;
  double most = -1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double length = count(axis) > 1 ? count(axis) * std::fabs(steps[axis]) : 0;
    if (length > most) {
      most = length;
      longest = axis;
    }
  }
  return longest;
}

Box32 InstanceRange::box(const InstanceGrid& grid) const {
  const Vec3d first = grid.repeat.offset(from[0], from[1], from[2]);
  const Vec3d last = grid.repeat.offset(to[0] - 1, to[1] - 1, to[2] - 1);
  const Vec3f slack{grid.slack, grid.slack, grid.slack};
  return {static_cast<Vec3f>(grid.box.min + lower(first, last)) - slack,
          static_cast<Vec3f>(grid.box.max + upper(first, last)) + slack};
}

float InstanceGrid::slack_of(const Aabb& all) {
  const Vec3d far = upper(all.max, all.min * -1.0);
  return static_cast<float>(std::max({far.x, far.y, far.z}) * tolerance::grid_box +
                            tolerance::box_face_least);
}

}  // namespace tia
