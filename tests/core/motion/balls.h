// What the tests of motion share: places on paths, boxes of planes, distances found by trying.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/motion/exact.h"
#include "tests/core/support.h"

namespace tia::test {

/// The knot that a path is on at a time. Domain: not before the first.
inline const Knot& knot_at(const std::vector<Knot>& path, double time) {
  const auto after = std::upper_bound(path.begin(), path.end(), time,
                                      [](double t, const Knot& knot) { return t < knot.time; });
  return *(after - 1);
}
inline Vec3d place_at(const std::vector<Knot>& path, double time) {
  return center_at(knot_at(path, time), time);
}

inline double momentum_along(const Vec3d& way, const ExactWorld& world, const Motion& motion,
                             double time) {
  double sum = 0;
  for (std::size_t i = 0; i < world.balls.size(); ++i)
    sum += world.balls[i].mass * dot(way, velocity_at(knot_at(motion.paths[i], time), time));
  return sum;
}

/// Six planes around a cube from the origin to `side`.
inline std::vector<FixedShape> room(double side) {
  const Vec3d far{side, side, side};
  return {FixedPlane{{}, {1, 0, 0}},  FixedPlane{{}, {0, 1, 0}},  FixedPlane{{}, {0, 0, 1}},
          FixedPlane{far, {1, 0, 0}}, FixedPlane{far, {0, 1, 0}}, FixedPlane{far, {0, 0, 1}}};
}
/// n balls on a lattice in a room of that side, with velocities by chance.
inline ExactWorld balls_in_room(int n, double side, double radius, double speed, Random& random) {
  ExactWorld world;
  world.fixed = room(side);
  int along = 1;
  while (along * along * along < n) ++along;
  const double pitch = side / along;
  for (int i = 0; i < n; ++i) {
    const int x = i % along, y = i / along % along, z = i / along / along;
    const Vec3d at{x + 0.5, y + 0.5, z + 0.5};
    const Vec3d velocity = random.point(speed);
    world.balls.push_back({at * pitch, velocity, radius, random.in(0.5, 2)});
  }
  return world;
}
/// How deep balls are in each other or in the walls of a room, at most, at a time.
inline double deepest_overlap(const ExactWorld& world, const Motion& motion, double side,
                              double time) {
  double worst = -side;
  std::vector<Vec3d> at;
  for (const auto& path : motion.paths) at.push_back(place_at(path, time));
  for (std::size_t i = 0; i < at.size(); ++i) {
    const double r = world.balls[i].radius;
    for (std::size_t j = 0; j < i; ++j)
      worst = std::max(worst, r + world.balls[j].radius - length(at[i] - at[j]));
    for (const double x : {at[i].x, at[i].y, at[i].z})
      worst = std::max({worst, r - x, x + r - side});
  }
  return worst;
}

}  // namespace tia::test
