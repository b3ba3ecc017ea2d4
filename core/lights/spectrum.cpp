#include "core/lights/spectrum.h"

#include "core/math/cie.h"
#include "core/math/deterministic.h"

namespace tia {
namespace {

// Ozone's cross-section at 380, 400 .. 780 nm, such that with the number below it takes away what
// it does in Blender Cycles' sky model (intern/sky/source/sky_nishita.cpp, OZONE_COEFF).
// Space/units: 1e-25 m^2.
constexpr std::array<double, wavelengths> ozone_section{
    0.006, 0.011, 0.037, 0.136, 0.374, 0.752, 1.183, 1.800, 2.881, 3.891, 4.581,
    5.091, 4.004, 2.960, 2.091, 1.368, 0.865, 0.616, 0.419, 0.277, 0.313};
// 300 Dobson units on the 15 km that the ozone would fill where it is thickest.
constexpr double ozone_number = 300 * 2.6867e20 / 15e3;

// The sun as a black body of 5772 K (IAU 2015, resolution B3), but for a factor. Source: Planck.
double sun_light(double nm) {
  const double m = nm * 1e-9;
  constexpr double hc_over_k = 0.01438776877;  // CODATA 2018, m K
  return 1e-30 / (m * m * m * m * m * (exp_of(hc_over_k / (m * 5772)) - 1));
}

Spectrum make_spectrum() {
  Spectrum all{};
  double luminance = 0;
  for (std::size_t i = 0; i < wavelengths; ++i) {
    const double nm = first_nm + step_nm * static_cast<double>(i);
    const Vec3d response = cie_xyz(nm);
    all.air[i] = air_scattering(nm);
    all.ozone[i] = ozone_section[i] * 1e-25 * ozone_number;
    all.light[i] = linear_srgb(response) * sun_light(nm);
    luminance += response.y * sun_light(nm);
  }
  for (Vec3d& each : all.light) each = each * (1 / luminance);
  return all;
}

}  // namespace

double air_scattering(double nm) {
  const double s = 1e6 / (nm * nm), metres = nm * 1e-9;
  const double n = 1 + 1e-8 * (8060.51 + 2480990 / (132.274 - s) + 17455.7 / (39.32957 - s));
  constexpr double number = 2.546899e25, king = 1.048;
  const double n2 = n * n - 1, m2 = metres * metres;
  return 8 * pi * pi * pi * n2 * n2 * king / (3 * number * m2 * m2);
}

const Spectrum& spectrum() {
  static const Spectrum all = make_spectrum();
  return all;
}

}  // namespace tia
