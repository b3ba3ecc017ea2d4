// Rays at a smooth surface: mirrored, refracted, and how light parts between the two.
#pragma once

#include "core/math/wide.h"

namespace tia {

/// The mirrored direction. Domain: unit n.
template <class Real>
Vec3<Real> mirrored(const Vec3<Real>& d, const Vec3<Real>& n) {
  const Real c = dot(d, n);
  return d - n * (c + c);
}

/// Refraction: the way on behind the surface.
template <class Real>
struct Refraction {
  Vec3<Real> wt;
  Real cos_in, cos_out;  ///< of the angles to the normal on either side
  Mask<Real> total;      ///< where there is no way on: total internal reflection
};

/// Domain: unit d and n, d.n <= 0; eta is the index before the surface over the one behind it.
/// Source: Snell's law in vectors: eta d + (eta c - sqrt(1 - eta^2 (1 - c^2))) n, c = -d.n.
template <class Real>
Refraction<Real> refracted(const Vec3<Real>& d, const Vec3<Real>& n, const Real& eta) {
  using std::sqrt;
  const Real c = -dot(d, n);
  const Real square = Real(1) - eta * eta * (Real(1) - c * c);
  const Mask<Real> total = square < Real(0);
  const Real cos_out = sqrt(max_of(square, Real(0)));
  return {normalize(d * eta + n * (eta * c - cos_out)), c, cos_out, total};
}

/// The share of unpolarised light that is mirrored between two dielectrics, 1 where all of it is.
/// Domain: the cosines are those of one refraction.
/// Source: Born, Wolf, Principles of Optics, 1.5.2 (20) and (21), both polarisations averaged.
template <class Real>
Real fresnel(const Real& before, const Real& behind, const Refraction<Real>& at) {
  const Real across =
      (before * at.cos_in - behind * at.cos_out) / (before * at.cos_in + behind * at.cos_out);
  const Real along =
      (behind * at.cos_in - before * at.cos_out) / (behind * at.cos_in + before * at.cos_out);
  const Real share = (across * across + along * along) * Real(0.5F);
  // Between equal indices there is no surface; along one of them the share is 0/0.
  const Real parted = select(before == behind, Real(0), share);
  return select(at.total, Real(1), parted);
}

}  // namespace tia
