// The thesis' integrator: nearest hit, hard shadows, Lambert. No recursion.
#pragma once

#include "core/integrators/scope.h"

namespace tia {

/// Light from a surface point: over all lamps that it sees albedo * max(0, n.l) * lamp, plus the
/// emission of its own. Lanes outside `here` are meaningless and cast no shadow rays.
template <class Scope, class Point, class Real>
Vec3<Real> shade(Scope& scope, const Point& at, const Matte& matte, Real offset, Mask<Real> here) {
  Vec3<Real> light = lift<Real>(matte.emission);
  for (const Lamp& lamp : scope.world.lamps) {
    const Real cosine = visible_cosine(scope, at, lamp, offset, here);
    if (!any(cosine > Real(0))) continue;
    light = light + lift<Real>(matte.albedo) * lift<Real>(lamp.color) * cosine;
  }
  return light;
}

/// Light along a ray: that of the nearest surface, else the background.
/// Returns: linear RGB, unclamped; meaningless in lanes that are not active.
/// Source: the thesis, steps 3-5.
template <class Scope, class Real>
Vec3<Real> thesis(Scope& scope, const Ray<Real>& ray, Mask<Real> active) {
  const Hit<Real> hit = first_hit(scope, ray, active);
  Vec3<Real> light = lift<Real>(scope.world.background);
  for_each_winner(hit, active, [&](int part, Mask<Real> here) {
    const auto at = scope.surface_of(ray, hit, part, here);
    const Real offset = shadow_offset(hit.t, at.p);
    light = select(here, shade(scope, at, scope.world.matte_of(part), offset, here), light);
  });
  return light;
}

}  // namespace tia
