// What the eye makes of light of one wavelength.
#pragma once

#include "core/math/powers.h"
#include "core/math/wide.h"

namespace tia {

namespace detail {

template <class Real>
Real bell(const Real& nm, double weight, double middle, double below, double above) {
  const Real off = nm - lift<Real>(middle);
  const Real x = off * select(off < Real(0), lift<Real>(below), lift<Real>(above));
  return lift<Real>(weight) * exp_of(Real(-0.5F) * x * x);
}

}  // namespace detail

/// The CIE 1931 observer's response, X, Y and Z. Space/units: nanometres.
/// Source: Wyman, Sloan, Shirley, "Simple analytic approximations to the CIE XYZ color matching
/// functions", JCGT 2(2) (2013), the sums of bells.
template <class Real>
Vec3<Real> cie_xyz(const Real& nm) {
  using detail::bell;
  return {bell(nm, 0.362, 442.0, 0.0624, 0.0374) + bell(nm, 1.056, 599.8, 0.0264, 0.0323) -
              bell(nm, 0.065, 501.1, 0.0490, 0.0382),
          bell(nm, 0.821, 568.8, 0.0213, 0.0247) + bell(nm, 0.286, 530.9, 0.0613, 0.0322),
          bell(nm, 1.217, 437.0, 0.0845, 0.0278) + bell(nm, 0.681, 459.0, 0.0385, 0.0725)};
}

/// The same colour in linear sRGB, some of it below 0 where it lies outside. Source: IEC 61966-2-1.
template <class Real>
Vec3<Real> linear_srgb(const Vec3<Real>& xyz) {
  const auto row = [&](double x, double y, double z) {
    return lift<Real>(x) * xyz.x + lift<Real>(y) * xyz.y + lift<Real>(z) * xyz.z;
  };
  return {row(3.2406, -1.5372, -0.4986), row(-0.9689, 1.8758, 0.0415),
          row(0.0557, -0.2040, 1.0570)};
}

}  // namespace tia
