// What a surface reflects by Fresnel's or Schlick's equations, in the mean and between two sides.
#pragma once

#include "core/math/wide.h"

namespace tia {

/// Schlick's share by the cosine's mean, 2 times the integral of c (1 - c)^5 being 1/21.
template <class Real>
Vec3<Real> mean_fresnel(const Vec3<Real>& f0, const Real& f90) {
  return f0 + (Vec3<Real>{f90, f90, f90} - f0) * Real(1.0F / 21);
}
/// Fresnel's share by the cosine's mean, for light that comes from the thinner side; the other
/// side's follows from it. Source: the fit of Kulla, Conty (2017).
template <class Real>
Real mean_dielectric(const Real& eta) {
  const Real denser = max_of(eta, Real(1) / eta);
  const Real outer = (denser - Real(1)) / (Real(4.08567F) + Real(1.00071F) * denser);
  return select(eta < Real(1), Real(1) - (Real(1) - outer) * eta * eta, outer);
}
/// A pane's two sides, between which light goes to and fro.
/// Source: Pharr, Jakob, Humphreys, "Physically Based Rendering", 4th ed., 9.5.
template <class Real>
Real of_pane(const Real& reflected) {
  return (reflected + reflected) / (Real(1) + reflected);
}

}  // namespace tia
