// Wavelengths: what a path of one carries, and how much it is bent.
#pragma once

#include "core/math/cie.h"

namespace tia {

/// The visible wavelengths that paths draw from, evenly. Space/units: nanometres.
inline constexpr float shortest_wave = 380, longest_wave = 720;

/// What a path of white light carries at a wavelength, in linear sRGB, so that the mean over all is
/// (1, 1, 1), which the three factors make. Components may be below 0.
template <class Real>
Vec3<Real> wave_color(const Real& wave) {
  const Vec3<Real> rgb = linear_srgb(cie_xyz(wave));
  return {rgb.x * lift<Real>(2.65279), rgb.y * lift<Real>(3.34540), rgb.z * lift<Real>(3.50432)};
}

/// The index of refraction at a wavelength, where it is `ior` at that of sodium's d line and
/// `dispersion` is 20 over Abbe's number, (n_d - 1) / (n_F - n_C).
/// Source: Cauchy's first two terms; KHR_materials_dispersion.
template <class Real>
Real ior_at(const Real& ior, const Real& dispersion, const Real& wave) {
  constexpr double d = 587.6, f = 486.1, c = 656.3;
  constexpr auto slope = static_cast<float>(1 / (1 / (f * f) - 1 / (c * c)) / 20);
  constexpr auto of_d = static_cast<float>(1 / (d * d));
  const Real bend = (ior - Real(1)) * dispersion * Real(slope);
  return max_of(ior + bend * (Real(1) / (wave * wave) - Real(of_d)), Real(1));
}

}  // namespace tia
