// Rays at a smooth surface: reflected, refracted, and how light divides between the two.
#pragma once

#include "core/math/wide.h"

namespace tia {

/// The reflected direction. Domain: unit n.
template <class Real>
Vec3<Real> reflect(const Vec3<Real>& d, const Vec3<Real>& n) {
  const Real c = dot(d, n);
  return d - n * (c + c);
}

/// Refraction: the direction behind the surface, and what Fresnel's equations need of the angles.
template <class Real>
struct Refraction {
  Vec3<Real> wt;
  Real cos_i, cos_t;  ///< of the angles to the normal: of the incident and of the transmitted ray
  Mask<Real> total;   ///< total internal reflection: nothing is transmitted and wt has no meaning
};

/// Domain: unit d and n, d.n <= 0; eta is eta_i / eta_t, the index of refraction on the side that
/// the ray comes from over that on the other side.
/// Source: Snell's law in vectors: eta d + (eta c - sqrt(1 - eta^2 (1 - c^2))) n, c = -d.n.
template <class Real>
Refraction<Real> refract(const Vec3<Real>& d, const Vec3<Real>& n, const Real& eta) {
  using std::sqrt;
  const Real c = -dot(d, n);
  const Real square = Real(1) - eta * eta * (Real(1) - c * c);
  const Mask<Real> total = square < Real(0);
  const Real cos_t = sqrt(max_of(square, Real(0)));
  return {normalize(d * eta + n * (eta * c - cos_t)), c, cos_t, total};
}

/// The share of unpolarised light that is reflected between two dielectrics, 1 where all of it is.
/// Domain: `at` is the refraction for these two indices, eta_i on the side that the ray comes from.
/// Source: Born, Wolf, Principles of Optics, 1.5.2 (20) and (21), both polarisations averaged.
template <class Real>
Real fr_dielectric(const Real& eta_i, const Real& eta_t, const Refraction<Real>& at) {
  const Real perpendicular =
      (eta_i * at.cos_i - eta_t * at.cos_t) / (eta_i * at.cos_i + eta_t * at.cos_t);
  const Real parallel =
      (eta_t * at.cos_i - eta_i * at.cos_t) / (eta_t * at.cos_i + eta_i * at.cos_t);
  const Real share = (perpendicular * perpendicular + parallel * parallel) * Real(0.5F);
  // Between equal indices nothing is reflected; at grazing incidence the quotients would be 0/0.
  const Real reflected = select(eta_i == eta_t, Real(0), share);
  return select(at.total, Real(1), reflected);
}

}  // namespace tia
