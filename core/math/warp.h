// Maps from the unit square to where samples are wanted.
#pragma once

#include <utility>

#include "core/math/wide.h"

namespace tia {

template <class Real>
struct DiscPoint {
  Real x, y;
};

/// A point of the unit disc for a point of the unit square; equal areas go to equal areas, near
/// points to near ones.
/// Source: Shirley, Chiu, "A low distortion map between disk and square", 1997. Its angles are at
/// most pi/4, where Taylor's sums for sine and cosine end below float's rounding.
template <class Real>
DiscPoint<Real> square_to_disc(Real u, Real v) {
  const Real a = u + u - Real(1), b = v + v - Real(1);
  const Mask<Real> flat = abs_of(a) > abs_of(b);
  const Real radius = select(flat, a, b), aside = select(flat, b, a);
  const Real share = aside / select(radius == Real(0), Real(1), radius);
  const Real angle = Real(0.785398163F) * share, square = angle * angle;
  const Real sine =
      angle *
      (Real(1) - square * (Real(1.0F / 6) -
                           square * (Real(1.0F / 120) -
                                     square * (Real(1.0F / 5040) - square * Real(1.0F / 362880)))));
  const Real cosine =
      Real(1) -
      square * (Real(0.5F) - square * (Real(1.0F / 24) -
                                       square * (Real(1.0F / 720) - square * Real(1.0F / 40320))));
  return {radius * select(flat, cosine, sine), radius * select(flat, sine, cosine)};
}

/// Two axes across a unit vector and each other, right-handed with it.
/// Source: Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017.
template <class Real>
std::pair<Vec3<Real>, Vec3<Real>> axes_around(const Vec3<Real>& n) {
  const Real sign = select(n.z < Real(0), Real(-1), Real(1));
  const Real a = Real(-1) / (sign + n.z), b = n.x * n.y * a;
  return {{Real(1) + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}};
}

/// A direction of the upper hemisphere around the unit vector n, of density cos / pi.
/// Source: Malley's method (Pharr, Jakob, Humphreys, "Physically Based Rendering", 4th ed., A.5.3):
/// the points of the unit disc, evenly, and what stands above them on the sphere.
template <class Real>
Vec3<Real> square_to_cosine_hemisphere(const Vec3<Real>& n, const Real& u, const Real& v) {
  using std::sqrt;
  const DiscPoint<Real> d = square_to_disc(u, v);
  const Real z = sqrt(max_of(Real(1) - d.x * d.x - d.y * d.y, Real(0)));
  const auto [across, along] = axes_around(n);
  return across * d.x + along * d.y + n * z;
}

/// A direction of the hemisphere around the third axis, evenly.
template <class Real>
Vec3<Real> square_to_uniform_hemisphere(const Real& u, const Real& v) {
  using std::sqrt;
  const DiscPoint<Real> d = square_to_disc(u, v);
  const Real away = d.x * d.x + d.y * d.y, wider = sqrt(max_of(Real(2) - away, Real(0)));
  return {d.x * wider, d.y * wider, max_of(Real(1) - away, Real(0))};
}

}  // namespace tia
