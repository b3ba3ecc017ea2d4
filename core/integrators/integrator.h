// THE LIST of integrators: a new one is one file beside this one, a name in scene.h's list and a
// line in radiance().
#pragma once

#include "core/integrators/thesis.h"

namespace tia {

/// Returns: linear RGB along the ray, unclamped. Lanes outside `active` do not count as rays. The
/// ray may meet no object but `objects`.
template <class Real>
Vec3<Real> radiance(IntegratorName name, const World& world, const std::vector<int>& objects,
                    const Ray<Real>& ray, Mask<Real> active, RayTally& rays) {
  switch (name) {
    case IntegratorName::thesis: break;
  }
  return thesis(world, objects, ray, active, rays);
}

}  // namespace tia
