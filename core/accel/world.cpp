#include "core/accel/world.h"

namespace tia {

Affine World::to_space(int space, std::int64_t copy) const {
  const int repeated_by = spaces[static_cast<std::size_t>(space)].copies;
  if (repeated_by < 0) return {};
  const Copies& grid = copies[static_cast<std::size_t>(repeated_by)];
  const std::int64_t all = grid.repeat.copies();
  const Affine to_copy = Affine::translation(-grid.offset(copy % all));
  return to_copy * grid.to_group * to_space(grid.outside, copy / all);
}

std::vector<int> candidates(const World& world, const Beam& beam) {
  std::vector<int> found;
  for (std::size_t i = 0; i < world.balls.size(); ++i)
    if (beam.may_meet(world.balls[i].sphere.center, world.balls[i].sphere.radius))
      found.push_back(static_cast<int>(i));
  return found;
}

}  // namespace tia
