#include "core/accel/copies.h"

#include <cmath>

namespace tia {

Vec3d Copies::offset(std::int64_t number) const {
  const std::int64_t nx = repeat.count[0], ny = repeat.count[1];
  return repeat.offset(static_cast<int>(number % nx), static_cast<int>(number / nx % ny),
                       static_cast<int>(number / nx / ny));
}

std::size_t CopyRange::longest(const Vec3d& step) const {
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

Box32 CopyRange::box(const Repeat& repeat, const Aabb& one) const {
  const Vec3d first = repeat.offset(from[0], from[1], from[2]);
  const Vec3d last = repeat.offset(to[0] - 1, to[1] - 1, to[2] - 1);
  return rounded_outwards({one.min + lower(first, last), one.max + upper(first, last)});
}

}  // namespace tia
