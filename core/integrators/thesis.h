// The thesis' integrator: nearest hit, hard shadows, Lambert. No recursion.
#pragma once

#include "core/integrators/scope.h"

namespace tia {

/// Light along a ray: from the nearest surface, over all lamps that it sees, albedo * max(0, n.l) *
/// lamp, plus the emission of its own; where there is none, the background.
/// Returns: linear RGB, unclamped; meaningless in lanes that are not active.
/// Source: the thesis, steps 3-5.
template <class Scope, class Real>
Vec3<Real> thesis(Scope& scope, const Ray<Real>& ray, Mask<Real> active) {
  const Hit<Real> hit = first_hit(scope, ray, active);
  const auto seen = surfaces(scope, ray, hit, active);
  const Vec3<Real> background = lift<Real>(scope.world.background);
  if (!any(seen.here)) return background;
  const Real offset = shadow_offset(hit.t, seen.at.p);
  Vec3<Real> light = seen.emission;
  for (const Lamp& lamp : scope.world.lamps) {
    const Real cosine = visible_cosine(scope, seen.at, lamp, offset, seen.here);
    if (any(cosine > Real(0))) light = light + seen.albedo * lift<Real>(lamp.color) * cosine;
  }
  return select(seen.here, light, background);
}

}  // namespace tia
