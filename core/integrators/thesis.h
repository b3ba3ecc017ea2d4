// The thesis' integrator: nearest hit, hard shadows, Lambert. No recursion.
#pragma once

#include "core/accel/world.h"

namespace tia {

/// RayTally: rays of one block by kind; exact.
struct RayTally {
  long primary = 0, shadow = 0;
};

/// How far a shadow ray starts above its surface: 1e-4 at the thesis' distances, in proportion to
/// the distance elsewhere, so that scenes of any scale have neither acne nor leaks.
template <class Real>
Real shadow_offset(Real t, const Vec3<Real>& p) {
  const Real extent = max_of(max_of(abs_of(p.x), abs_of(p.y)), abs_of(p.z));
  return Real(5e-6F) * max_of(t, extent);
}

/// Light along a ray: the background, or over all lamps that the point sees
/// albedo * max(0, n.l) * lamp, plus the surface's own emission.
/// Returns: linear RGB, unclamped. Lanes outside `active` are traced but not counted. The ray may
/// meet no object but `objects`.
/// Source: the thesis, steps 3-5.
template <class Real>
Vec3<Real> thesis(const World& world, const std::vector<int>& objects, const Ray<Real>& ray,
                  Mask<Real> active, RayTally& rays) {
  rays.primary += count(active);
  const Hit<Real> hit = closest_hit(world, objects, ray);
  const Mask<Real> found = hit.t < Real(infinity);
  const Vec3<Real> background = lift<Real>(world.background);
  if (!any(found)) return background;

  const SurfacePoint<Real> at = surface(world, ray, hit, found);
  const Vec3<Real> start = at.p + at.n * shadow_offset(hit.t, at.p);
  Vec3<Real> light = at.emission;
  for (const Lamp& lamp : world.lamps) {
    const Vec3<Real> to_lamp = lift<Real>(lamp.position) - at.p;
    const Real distance = length(to_lamp);
    const Vec3<Real> l = to_lamp * (Real(1) / distance);
    const Real n_dot_l = dot(at.n, l);
    const Mask<Real> lit = found & (n_dot_l > Real(0));
    if (!any(lit)) continue;
    rays.shadow += count(lit & active);
    const Mask<Real> dark = occluded(world, Ray<Real>{start, l}, distance, lamp.object);
    const Real cosine = select(lit & !dark, n_dot_l, Real(0));
    light = light + at.albedo * lift<Real>(lamp.color) * cosine;
  }
  return select(found, light, background);
}

}  // namespace tia
