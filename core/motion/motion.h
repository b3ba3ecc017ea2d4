// Motion: what moving bodies do in time, whichever solver found it.
#pragma once

#include <cstddef>
#include <vector>

#include "core/math/vec3.h"

namespace tia {

/// Knot: where a body's centre is at a time and how it goes on: until the next knot, or the end, on
/// a parabola. Of a jump (a collision, an entrance) the knot has the velocity after it.
/// Space/units: scene units, seconds.
struct Knot {
  double time = 0;
  Vec3d center{}, velocity{}, acceleration{};
  bool operator==(const Knot&) const = default;
};

/// The centre on a knot's parabola at a time.
inline Vec3d center_at(const Knot& knot, double time) {
  const double dt = time - knot.time;
  return knot.center + (knot.velocity + knot.acceleration * (dt / 2)) * dt;
}
inline Vec3d velocity_at(const Knot& knot, double time) {
  return knot.velocity + knot.acceleration * (time - knot.time);
}

/// BodyContact: an impulse that b gave a. Bodies are numbered as they were given, fixed things go
/// on after them. Space/units: impulse in mass times velocity.
struct BodyContact {
  double time = 0;
  std::size_t a = 0, b = 0;
  Vec3d point{}, normal{};  ///< unit, from b to a
  double impulse = 0;
};

/// BodyEnergy: of all bodies that are there; potential = -m g.x.
struct BodyEnergy {
  double time = 0, kinetic = 0, potential = 0;
};

/// Motion. Shape: a path a body, each of at least one knot at ascending times, of which the first
/// is when the body enters; none of a body that never does. Of contacts and energies at most
/// `most_records` each: of more every second one, fourth, ..., with the first and the last.
struct Motion {
  static constexpr std::size_t most_records = 100'000;
  std::vector<std::vector<Knot>> paths;
  std::vector<BodyContact> contacts;
  std::vector<BodyEnergy> energy;
  std::size_t events = 0;  ///< collisions, and whatever else begins a knot
};

}  // namespace tia
