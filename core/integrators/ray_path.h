// The path of a packet's rays from the camera.
#pragma once

#include <array>
#include <cstdint>

#include "core/integrators/media.h"
#include "core/math/rng.h"

namespace tia {

/// SamplerState: the pixels that the rays belong to and the index of the sample. Random numbers
/// depend on these and on the dimension that they are drawn for, and on nothing else.
template <class Real>
struct SamplerState {
  static constexpr auto n = static_cast<std::size_t>(lanes<Real>);
  std::array<std::uint32_t, n> x{}, y{};
  std::uint32_t sample = 0;
  RandomKey key{0};
};

/// RayKind: what rays count as.
enum class RayKind { primary, reflection, refraction };

/// RayCounts: exact numbers of rays by kind. For each light sample with n.l > 0 at a hit there is
/// one shadow ray.
struct RayCounts {
  std::int64_t primary = 0, shadow = 0, reflection = 0, refraction = 0;
  std::int64_t cut =
      0;  ///< of paths, whose last ray would have gone on if it were not for max_depth
  bool operator==(const RayCounts&) const = default;
  std::int64_t all() const { return primary + shadow + reflection + refraction; }
  RayCounts& operator+=(const RayCounts& more) {
    primary += more.primary, shadow += more.shadow;
    reflection += more.reflection, refraction += more.refraction;
    cut += more.cut;
    return *this;
  }
  void count(RayKind kind, int rays) {
    (kind == RayKind::primary      ? primary
     : kind == RayKind::reflection ? reflection
                                   : refraction) += rays;
  }
};

/// RayPath: how the rays of a packet have come from the camera.
template <class Real>
struct RayPath {
  const SamplerState<Real>& sampler_state;
  RayKind kind = RayKind::primary;
  int depth = 0;           ///< how many reflections and refractions there were
  std::uint32_t node = 1;  ///< tells the branches of the tree of rays apart, for random numbers
  const MediumTransition<Real>* transitions = nullptr;  ///< the last surface passed through
  Vec3<Real> absorption{};   ///< of the medium that they are in, per scene unit
  bool seen = true;          ///< whether they are the camera's own, or go on straight from these
  int passed = 0;            ///< how many blended surfaces they have gone straight through
  Real travelled = Real(0);  ///< how far it is from the camera to their origins

  /// At a distance t along them.
  RayPath reflected(const Real& t) const {
    return {sampler_state, RayKind::reflection, depth + 1, branch(0x9E3779B1),
            transitions,   absorption,          false,     passed,
            travelled + t};
  }
  RayPath refracted(const MediumTransition<Real>& at, const Medium<Real>& medium_t,
                    const Real& t) const {
    return {sampler_state, RayKind::refraction, depth + 1, branch(0x85EBCA77),
            &at,           medium_t.absorption, false,     passed,
            travelled + t};
  }
  /// Straight on behind what is there in part.
  RayPath straight(const Real& t) const {
    return {sampler_state, RayKind::refraction, depth, branch(0xC2B2AE35),
            transitions,   absorption,          seen,  passed + 1,
            travelled + t};
  }

 private:
  std::uint32_t branch(std::uint32_t turn) const { return (node ^ node >> 15U) * turn + 1; }
};

}  // namespace tia
