// The rays that are traced: made once, kept in arrays that both tracers read.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "core/accel/world/world.h"

namespace tia::bench {

enum class RayKind { primary, shadow, mirror, diffuse };
inline constexpr std::array<std::string_view, 4> ray_kind_names{"primary", "shadow", "mirror",
                                                                "diffuse"};

/// One ray, or as many as Real has lanes, from i on.
template <class Real>
Vec3<Real> vector_at(const std::array<std::vector<float>, 3>& from, std::size_t i) {
  return {load<Real>(&from[0][i]), load<Real>(&from[1][i]), load<Real>(&from[2][i])};
}

/// RaySet: rays of one kind in the packets that Tia's tracer makes of them, in its order: patches
/// of pixels within blocks. A lane stays with its pixel, so what hits nothing leaves holes.
struct RaySet {
  RayKind kind = RayKind::primary;
  std::array<std::vector<float>, 3> origin, direction;  ///< x, y and z
  std::vector<float> t_max;                             ///< infinite, or to the light; < 0: a hole
  std::size_t active = 0;                               ///< how many are no holes

  std::size_t size() const { return t_max.size(); }
  bool any_hit() const { return kind == RayKind::shadow; }
  bool coherent() const { return kind == RayKind::primary || kind == RayKind::shadow; }
  void add(const Vec3f& from, const Vec3f& way, float far);
  void add_hole() { add({0, 0, 0}, {0, 0, 1}, -1); }
};

/// Answers: t of each ray, infinite where it meets nothing; of a shadow ray 0 where it is blocked.
using Answers = std::vector<float>;

/// A pinhole's 640x480 rays, and what leaves the points that they hit: towards the light, mirrored,
/// and scattered by the cosine. Domain: a world of scene_of().
std::array<RaySet, 4> make_rays(const World& world);

/// The share of the rays on which two tracers disagree whether there is a hit, or where: by more
/// than 1e-4 of t.
double disagreement(const RaySet& rays, const Answers& a, const Answers& b);

}  // namespace tia::bench
