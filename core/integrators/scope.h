// What integrators share: the world, what this thread counts, first hits and shadow rays.
#pragma once

#include <vector>

#include "core/accel/trace.h"

namespace tia {

/// RayTally: rays of one block by kind, exact; and tests of boxes and surfaces, which depend on how
/// the rays were packed.
struct RayTally {
  std::int64_t primary = 0, shadow = 0, tests = 0;
};

/// Scope: the world as one block of the picture sees it.
struct Scope {
  const World& world;
  std::vector<int> balls;  ///< the balls that its camera rays may meet, in a world of few
  RayTally rays{};
};

/// What a camera ray meets first. Lanes that are not active do not count.
template <class Real>
Hit<Real> first_hit(Scope& scope, const Ray<Real>& ray, Mask<Real> active) {
  scope.rays.primary += count(active);
  if (scope.world.few_balls) return closest_hit(scope.world, scope.balls, ray);
  return closest_hit(scope.world, ray, active, scope.rays.tests);
}

/// How far a shadow ray starts above its surface: 1e-4 at the thesis' distances, in proportion to
/// the distance elsewhere, so that scenes of other scales have neither acne nor leaks.
template <class Real>
Real shadow_offset(Real t, const Vec3<Real>& p) {
  const Real extent = max_of(max_of(abs_of(p.x), abs_of(p.y)), abs_of(p.z));
  return Real(5e-6F) * max_of(t, extent);
}

/// n.l where the point sees the lamp, else 0. Lanes outside `here` cast no shadow rays.
template <class Real>
Real visible_cosine(Scope& scope, const SurfacePoint<Real>& at, const Lamp& lamp, Real offset,
                    Mask<Real> here) {
  const Vec3<Real> to_lamp = lift<Real>(lamp.position) - at.p;
  const Real distance = length(to_lamp);
  const Vec3<Real> l = to_lamp * (Real(1) / distance);
  const Real n_dot_l = dot(at.n, l);
  // Infinite or NaN where the lamp is nearer than float can tell.
  const Mask<Real> lit = here && n_dot_l > Real(0) && n_dot_l < Real(infinity);
  if (!any(lit)) return Real(0);
  scope.rays.shadow += count(lit);
  const Ray<Real> shadow_ray{at.p + at.ng * offset, l};
  const Mask<Real> dark = scope.world.few_balls ? occluded(scope.world, shadow_ray, distance, lamp)
                                                : occluded(scope.world, shadow_ray, distance, lamp,
                                                           lit, scope.rays.tests);
  return select(lit && !dark, n_dot_l, Real(0));
}

}  // namespace tia
