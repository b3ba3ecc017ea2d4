// How much light rough surfaces send on by a single scattering, from tables: what they lose is then
// given back as what is scattered again and again between the facets.
// Source: Kulla, Conty, "Revisiting physically based shading at Imageworks" (2017); Turquin,
// "Practical multiple scattering compensation for microfacet models" (2019).
#pragma once

#include "core/math/wide.h"

namespace tia {

namespace albedo_tables {
// Nodes lie evenly in the roots of cosine and alpha, along whose diagonal the facets' shadows
// begin, and in (eta - 1) / (eta + 1).
inline constexpr int metal_nodes = 32, sheen_nodes = 32, glass_nodes = 16, glass_indices = 17;
inline constexpr int grain_nodes = 16, grain_glass_nodes = 8;
inline constexpr double last_index = 0.82;  // eta = 0.1 .. 10
constexpr double index_of_node(int i) { return last_index * (2.0 * i / (glass_indices - 1) - 1); }
}  // namespace albedo_tables

/// SchlickAlbedo: the share that facets reflect is a f0 + b f90 for Schlick's f0 + (f90 - f0)
/// (1 - c)^5, so a + b for those that absorb nothing.
template <class Real>
struct SchlickAlbedo {
  Real a, b;
};
/// For light along the cosine mu; by `rough`, the root of alpha, in [0,1]. Within 0.003.
template <class Real>
SchlickAlbedo<Real> schlick_albedo(const Real& mu, const Real& rough);
/// Its mean over the hemisphere, by the cosine.
template <class Real>
SchlickAlbedo<Real> mean_schlick_albedo(const Real& rough);

/// The share that a dielectric's facets reflect and let pass together, eta as in Dielectric.
template <class Real>
Real glass_albedo(const Real& mu, const Real& rough, const Real& eta);
template <class Real>
Real mean_glass_albedo(const Real& rough, const Real& eta);

/// The means of facets stretched by two alphas (grain_albedo.h), by the alphas' roots.
template <class Real>
SchlickAlbedo<Real> mean_grain_albedo(const Real& rough_x, const Real& rough_y);
template <class Real>
Real mean_grain_glass_albedo(const Real& rough_x, const Real& rough_y, const Real& eta);

/// The share that white sheen scatters.
template <class Real>
Real sheen_albedo(const Real& mu, const Real& rough);

}  // namespace tia
