// All crossings of a ray with surfaces, in double, for /explain.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/accel/world/trace.h"

namespace tia {

/// Meeting: one crossing of a ray with a surface of the world.
/// Space/units: world space; the normal is the geometric one, outwards, and unit.
struct Meeting {
  double t = 0;
  int primitive = 0, element = 0;
  std::int64_t instance = 0;
  Vec3d point{}, normal{};
  Vec2d uv{};
  bool front = false;                ///< whether the ray comes from outside
  std::optional<Bracket> bracket{};  ///< of its root, if it is the root of an equation
};

inline constexpr std::size_t most_hits = 10'000;

/// All crossings with t > 0, ascending; at equal t in the scene's order. A crossing of an
/// edge that triangles of a mesh share is one crossing.
/// Errors: InputError (limit) where there are more than most_hits, or where the ray
/// would be tried on millions of things.
std::vector<Meeting> all_hits(const World& world, const Ray<double>& ray);

}  // namespace tia
