// The shadows on a ground that is not there, where rays of the camera meet no object.
#pragma once

#include <array>
#include <utility>

#include "core/integrators/integrator.h"

namespace tia {

/// 1 in the lanes of those bits, else 0.
template <class Real>
Real ones_in(unsigned bits) {
  std::array<LaneOf<Real>, static_cast<std::size_t>(lanes<Real>)> each;
  for (std::size_t i = 0; i < each.size(); ++i) each[i] = static_cast<LaneOf<Real>>(bits >> i & 1U);
  return load<Real>(each.data());
}

/// GroundLight: what a packet's rays find on the ground: the luminance there with the objects and
/// without. Both are 0 in lanes that do not meet it.
template <class Real>
struct GroundLight {
  Mask<Real> here{};
  Real with = Real(0), without = Real(0);

  /// 1 - E / E0 of each ray by itself, at least 0.
  Real alpha() const {
    const Mask<Real> lit = here && without > Real(0);
    const Real passed = min_of(with / select(lit, without, Real(1)), Real(1));
    return select(lit, Real(1) - passed, Real(0));
  }
};

/// GroundShadow: finds the light on a world's ground, by the integrator of the picture and with the
/// same random numbers with the objects and without: where nothing is in the way both are equal.
template <class Real>
class GroundShadow {
 public:
  /// Domain: a world with a ground. The cone is that of the camera's rays.
  GroundShadow(const World& world, IntegratorName integrator, const Rules& rules,
               const PixelCone& cone, const WorkCounter::Report& report)
      : integrator_(integrator),
        plane_(world.ground->plane),
        with_{world.ground->with, WorkCounter(report), rules, {}, 0, cone},
        without_{world.ground->without, WorkCounter(report), rules, {}, 0, cone} {}

  /// Rays are counted with those given. Errors: the report's.
  [[gnu::noinline]] GroundLight<Real> light(const Ray<Real>& ray, Mask<Real> missed,
                                            const SamplerState<Real>& sampler_state,
                                            RayCounts& rays) {
    const Real t = intersect(plane_, RootRay<Real>(ray));
    const Mask<Real> above = dot(ray.direction, lift<Real>(plane_.frame.n)) < Real(0);
    GroundLight<Real> found{missed && above && t < Real(infinity)};
    if (!any(found.here)) return found;
    // From just before it, so that they meet it and not what the camera does not see.
    const Real most = select(found.here, t * Real(0.984375F), Real(0));
    const Ray<Real> near{ray.origin + ray.direction * most, ray.direction};
    const auto luminance = [&](WorldView& world_view) {
      const Vec3<Real> L = radiance(integrator_, world_view, near, found.here, sampler_state);
      count(std::exchange(world_view.rays, {}), rays);
      const Real Y = Real(0.2126F) * L.x + Real(0.7152F) * L.y + Real(0.0722F) * L.z;
      return select(found.here, Y, Real(0));
    };
    found.with = luminance(with_);
    found.without = luminance(without_);
    return found;
  }

 private:
  // They come from what the camera sees, as those do that surfaces send on.
  static void count(const RayCounts& own, RayCounts& rays) {
    rays.reflection += own.primary + own.reflection;
    rays.shadow += own.shadow;
    rays.refraction += own.refraction;
    rays.cut += own.cut;
  }

  IntegratorName integrator_;
  const PlaneForm& plane_;
  WorldView with_, without_;
};

}  // namespace tia
