// Wavelengths: what a path of one carries, and how much it is bent.
#pragma once

#include "core/math/powers.h"
#include "core/math/wide.h"

namespace tia {

/// The visible wavelengths that paths draw from, evenly. Space/units: nanometres.
inline constexpr float shortest_wave = 380, longest_wave = 720;

namespace detail {

template <class Real>
Real bell(const Real& wave, float weight, float middle, float below, float above) {
  const Real off = wave - Real(middle);
  const Real x = off * select(off < Real(0), Real(below), Real(above));
  return Real(weight) * exp_of(Real(-0.5F) * x * x);
}

}  // namespace detail

/// What a path of white light carries at a wavelength, in linear sRGB, so that the mean over all is
/// (1, 1, 1). Components may be below 0, for pure colours lie outside of the screen's.
/// Source: the 1931 observer: Wyman, Sloan, Shirley, "Simple analytic approximations to the CIE XYZ
/// color matching functions", JCGT 2(2) (2013), the sums of bells; sRGB: IEC 61966-2-1. The three
/// factors are what the mean of each component is divided by.
template <class Real>
Vec3<Real> wave_color(const Real& wave) {
  using detail::bell;
  const Real x = bell(wave, 0.362F, 442.0F, 0.0624F, 0.0374F) +
                 bell(wave, 1.056F, 599.8F, 0.0264F, 0.0323F) -
                 bell(wave, 0.065F, 501.1F, 0.0490F, 0.0382F);
  const Real y =
      bell(wave, 0.821F, 568.8F, 0.0213F, 0.0247F) + bell(wave, 0.286F, 530.9F, 0.0613F, 0.0322F);
  const Real z =
      bell(wave, 1.217F, 437.0F, 0.0845F, 0.0278F) + bell(wave, 0.681F, 459.0F, 0.0385F, 0.0725F);
  return {(Real(3.2406F) * x - Real(1.5372F) * y - Real(0.4986F) * z) * Real(2.65279F),
          (Real(1.8758F) * y - Real(0.9689F) * x + Real(0.0415F) * z) * Real(3.34540F),
          (Real(0.0557F) * x - Real(0.2040F) * y + Real(1.0570F) * z) * Real(3.50432F)};
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
