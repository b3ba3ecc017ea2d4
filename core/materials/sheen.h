// Sheen: the light that upright fibres scatter forwards and backwards at the rims of cloth.
#pragma once

#include "core/math/powers.h"
#include "core/math/wide.h"

namespace tia {

/// The least alpha; below, the lobe is narrower than its samples find.
inline constexpr float least_sheen = 0.01F;

namespace detail {

/// How much fibres hide each other from the cosine c, a fit.
template <class Real>
Real sheen_lambda(const Real& c, const Real& alpha) {
  const Real smooth = (Real(1) - alpha) * (Real(1) - alpha);
  const auto mix = [&](float rough, float even) {
    return Real(rough) + Real(even - rough) * smooth;
  };
  const Real a = mix(21.5473F, 25.3245F), b = mix(3.82987F, 3.32435F),
             e = mix(-4.32054F, -4.85967F);
  const Real power = mix(0.19823F, 0.16801F), d = mix(-1.97760F, -1.27393F);
  const auto fit = [&](const Real& x) { return a / (Real(1) + b * pow_of(x, power)) + d * x + e; };
  const Mask<Real> grazing = c < Real(0.5F);
  const Real at = fit(select(grazing, c, max_of(Real(1) - c, Real(0))));
  return exp_of(select(grazing, at, Real(2) * fit(Real(0.5F)) - at));
}

}  // namespace detail

/// f cos(wi) of white sheen, both directions in the shading frame, above the surface.
/// Source: Estevez, Kulla, "Production friendly microfacet sheen BRDF" (2017), as in
/// KHR_materials_sheen.
template <class Real>
Real sheen_cos(const Vec3<Real>& wo, const Vec3<Real>& wi, const Real& alpha) {
  using std::sqrt;
  const Vec3<Real> h = normalize(wo + wi);
  const Real sine = sqrt(max_of(Real(1) - h.z * h.z, Real(0))), exponent = Real(1) / alpha;
  const Real density = (Real(2) + exponent) * pow_of(sine, exponent) * Real(0.159154943F);
  const Real hidden = detail::sheen_lambda(wo.z, alpha) + detail::sheen_lambda(wi.z, alpha);
  return density * min_of(Real(1) / ((Real(1) + hidden) * Real(4) * wo.z * wi.z), Real(1)) * wi.z;
}

}  // namespace tia
