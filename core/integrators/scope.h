// What integrators share: the world, what this thread counts, first hits and shadow rays.
#pragma once

#include <vector>

#include "core/accel/trace.h"

namespace tia {

/// RayTally: rays of one block by kind, exact.
struct RayTally {
  std::int64_t primary = 0, shadow = 0;
};

/// Scope: the world as one block of the picture sees it, and what the block's rays count to. Of two
/// kinds, which ask the same in their own way; an integrator is a template over them.
struct WorldScope {
  const World& world;
  Effort effort;
  RayTally rays{};

  template <class Real>
  Hit<Real> closest(const Ray<Real>& ray, Mask<Real> active) {
    return closest_hit(world, ray, active, effort);
  }
  template <class Real>
  Mask<Real> blocked(const Ray<Real>& ray, const Real& t_max, const Lamp& lamp, Mask<Real> active) {
    return occluded(world, ray, t_max, lamp, active, effort);
  }
  template <class Real>
  SurfacePoint<Real> surface_of(const Ray<Real>& ray, const Hit<Real>& hit, int part,
                                Mask<Real> here) const {
    return surface(world, ray, hit, part, here);
  }
};

/// A world of few balls and nothing else, of which the camera rays may meet those listed: small
/// enough to be tried one after another in registers.
struct BallScope {
  const World& world;
  std::vector<int> balls;
  RayTally rays{};

  template <class Real>
  Hit<Real> closest(const Ray<Real>& ray, Mask<Real>) const {
    return closest_ball(world, balls, ray);
  }
  template <class Real>
  Mask<Real> blocked(const Ray<Real>& ray, const Real& t_max, const Lamp& lamp, Mask<Real>) const {
    return occluded_by_balls(world, ray, t_max, lamp);
  }
  template <class Real>
  BallPoint<Real> surface_of(const Ray<Real>& ray, const Hit<Real>& hit, int part,
                             Mask<Real>) const {
    return ball_surface(world.balls[static_cast<std::size_t>(part)], ray, hit.t);
  }
};

/// What a camera ray meets first. Lanes that are not active do not count.
template <class Scope, class Real>
Hit<Real> first_hit(Scope& scope, const Ray<Real>& ray, Mask<Real> active) {
  scope.rays.primary += count(active);
  return scope.closest(ray, active);
}

/// Seen: the surfaces that a packet's rays have hit, each lane its own, so that what follows, their
/// shadow rays above all, is done for all lanes at once.
template <class Point, class Real>
struct Seen {
  Mask<Real> here;  ///< the lanes that have hit anything; the others are meaningless
  Point at{};
  Vec3<Real> albedo{}, emission{};
};

template <class Scope, class Real>
auto surfaces(const Scope& scope, const Ray<Real>& ray, const Hit<Real>& hit, Mask<Real> active) {
  using Point = decltype(scope.surface_of(ray, hit, 0, active));
  Seen<Point, Real> seen{active && hit.t < Real(infinity)};
  for_each_winner(hit, active, [&](int part, Mask<Real> here) {
    const Matte& matte = scope.world.matte_of(part);
    seen.at.take(scope.surface_of(ray, hit, part, here), here);
    seen.albedo = select(here, lift<Real>(matte.albedo), seen.albedo);
    seen.emission = select(here, lift<Real>(matte.emission), seen.emission);
  });
  return seen;
}

/// How far a shadow ray starts above its surface: 1e-4 at the thesis' distances, in proportion to
/// the distance elsewhere, so that scenes of other scales have neither acne nor leaks.
template <class Real>
Real shadow_offset(Real t, const Vec3<Real>& p) {
  const Real extent = max_of(max_of(abs_of(p.x), abs_of(p.y)), abs_of(p.z));
  return Real(5e-6F) * max_of(t, extent);
}

/// n.l where the point sees the lamp, else 0. Lanes outside `here` cast no shadow rays.
template <class Scope, class Point, class Real>
Real visible_cosine(Scope& scope, const Point& at, const Lamp& lamp, Real offset, Mask<Real> here) {
  const Vec3<Real> to_lamp = lift<Real>(lamp.position) - at.p;
  const Real distance = length(to_lamp);
  const Vec3<Real> l = to_lamp * (Real(1) / distance);
  const Real n_dot_l = dot(at.n, l);
  // Infinite or NaN where the lamp is nearer than float can tell.
  const Mask<Real> lit = here && n_dot_l > Real(0) && n_dot_l < Real(infinity);
  if (!any(lit)) return Real(0);
  scope.rays.shadow += count(lit);
  const Ray<Real> shadow_ray{at.p + at.side() * offset, l};
  const Mask<Real> dark = scope.blocked(shadow_ray, distance, lamp, lit);
  return select(lit && !dark, n_dot_l, Real(0));
}

}  // namespace tia
