// THE LIST of integrators: a new one is one file beside this one, a name in scene.h's list and a
// line in radiance().
#pragma once

#include "core/integrators/features.h"
#include "core/integrators/whitted.h"

namespace tia {

/// Whether it gathers light, else numbers of the surfaces.
inline bool gathers_light(IntegratorName name) {
  return name == IntegratorName::thesis || name == IntegratorName::whitted;
}

/// The thesis is a preset of whitted.
inline Rules rules_of(IntegratorName name, int max_depth) {
  return name == IntegratorName::thesis ? Rules{0, false, false} : Rules{max_depth};
}

/// Returns: linear RGB along a camera ray, unclamped, or a feature. Lanes that are not active come
/// out meaningless and do not count as rays.
template <class Real>
Vec3<Real> radiance(IntegratorName name, WorldScope& scope, const Ray<Real>& ray, Mask<Real> active,
                    const Draws<Real>& draws) {
  switch (name) {
    case IntegratorName::normal: return normal_feature(scope, ray, active);
    case IntegratorName::depth: return depth_feature(scope, ray, active);
    case IntegratorName::albedo: return albedo_feature(scope, ray, active);
    case IntegratorName::object: return object_feature(scope, ray, active);
    case IntegratorName::shadow: return shadow_feature(scope, ray, active);
    case IntegratorName::cost: return cost_feature(scope, ray, active);
    case IntegratorName::thesis:
    case IntegratorName::whitted: break;
  }
  return whitted(scope, ray, active, draws);
}

}  // namespace tia
