// The thesis' integrator: nearest hit, hard shadows, Lambert. No recursion.
#pragma once

#include "core/accel/world.h"

namespace tia {

/// RayTally: rays of one block by kind; exact.
struct RayTally {
  long primary = 0, shadow = 0;
};

/// How far a shadow ray starts above its surface: 1e-4 at the thesis' distances, in proportion to
/// the distance elsewhere, so that scenes of other scales have neither acne nor leaks.
template <class Real>
Real shadow_offset(Real t, const Vec3<Real>& p) {
  const Real extent = max_of(max_of(abs_of(p.x), abs_of(p.y)), abs_of(p.z));
  return Real(5e-6F) * max_of(t, extent);
}

/// Light from a surface point: over all lamps that it sees albedo * max(0, n.l) * lamp, plus the
/// emission of its own. Lanes outside `here` are meaningless and cast no shadow rays.
template <class Real>
Vec3<Real> shade(const World& world, const SurfacePoint<Real>& at, const Matte& matte, Real offset,
                 Mask<Real> here, Mask<Real> active, RayTally& rays) {
  const Vec3<Real> start = at.p + at.n * offset;
  Vec3<Real> light = lift<Real>(matte.emission);
  for (const Lamp& lamp : world.lamps) {
    const Vec3<Real> to_lamp = lift<Real>(lamp.position) - at.p;
    const Real distance = length(to_lamp);
    const Vec3<Real> l = to_lamp * (Real(1) / distance);
    const Real n_dot_l = dot(at.n, l);
    // Infinite or NaN where the lamp is nearer than float can tell.
    const Mask<Real> lit = here & (n_dot_l > Real(0)) & (n_dot_l < Real(infinity));
    if (!any(lit)) continue;
    rays.shadow += count(lit & active);
    const Mask<Real> dark = occluded(world, Ray<Real>{start, l}, distance, lamp.object);
    const Real cosine = select(lit & !dark, n_dot_l, Real(0));
    light = light + lift<Real>(matte.albedo) * lift<Real>(lamp.color) * cosine;
  }
  return light;
}

/// Light along a ray: that of the nearest surface, else the background.
/// Returns: linear RGB, unclamped. Lanes outside `active` are traced but not counted. The ray may
/// meet no object but `objects`.
/// Source: the thesis, steps 3-5.
template <class Real>
Vec3<Real> thesis(const World& world, const std::vector<int>& objects, const Ray<Real>& ray,
                  Mask<Real> active, RayTally& rays) {
  rays.primary += count(active);
  const Hit<Real> hit = closest_hit(world, objects, ray);
  Vec3<Real> light = lift<Real>(world.background);
  for_each_winner(hit, [&](int object, Mask<Real> here) {
    const SurfacePoint<Real> at = surface(world, ray, hit.t, object);
    const Matte& matte = world.mattes[static_cast<std::size_t>(object)];
    const Real offset = shadow_offset(hit.t, at.p);
    light = select(here, shade(world, at, matte, offset, here, active, rays), light);
  });
  return light;
}

}  // namespace tia
