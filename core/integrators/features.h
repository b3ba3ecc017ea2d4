// Feature images: what the camera rays find, as numbers instead of light.
#pragma once

#include "core/integrators/scope.h"

namespace tia {

/// The shading normal, towards the viewer; 0 where nothing is hit.
template <class Real>
Vec3<Real> normal_feature(WorldScope& scope, const Ray<Real>& ray, Mask<Real> active);

/// Distance along the unit ray; infinite where nothing is hit.
template <class Real>
Vec3<Real> depth_feature(WorldScope& scope, const Ray<Real>& ray, Mask<Real> active);

/// The surface's colour times what it scatters; 0 where nothing is hit.
template <class Real>
Vec3<Real> albedo_feature(WorldScope& scope, const Ray<Real>& ray, Mask<Real> active);

/// The object's number in the scene, from 1; 0 where nothing is hit.
template <class Real>
Vec3<Real> object_feature(WorldScope& scope, const Ray<Real>& ray, Mask<Real> active);

/// The share of the lamps that the point sees; 1 where nothing is hit or nothing shines.
template <class Real>
Vec3<Real> shadow_feature(WorldScope& scope, const Ray<Real>& ray, Mask<Real> active);

/// Tests of boxes and surfaces that the ray costs when it goes alone.
template <class Real>
Vec3<Real> cost_feature(WorldScope& scope, const Ray<Real>& ray, Mask<Real> active);

}  // namespace tia
