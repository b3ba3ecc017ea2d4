// How much light stretched facets send on by a single scattering: by some of the facets that w
// sees, for tables of all directions and grains would be large. Those of round facets are in
// albedo_tables.h.
#pragma once

#include "core/materials/albedo_tables.h"
#include "core/materials/microfacet.h"

namespace tia {

/// As those of albedo_tables.h, of facets stretched by two alphas, along w in their frame.
/// Returns: 1 at most; within 0.035, of a dielectric seen from inside 0.08, in the mean 0.01.
/// Source: Heitz, "Sampling the GGX distribution of visible normals", JCGT 7(4) (2018), equation
/// 19: the mean of what each facet that w sees reflects, times G2 / G1.
template <class Real>
SchlickAlbedo<Real> grain_albedo(const Ggx<Real>& ggx, const Vec3<Real>& w);
template <class Real>
Real grain_glass_albedo(const Ggx<Real>& ggx, const Vec3<Real>& w, const Real& eta);

}  // namespace tia
