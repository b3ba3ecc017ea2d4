// Spectrum: the sun's light by wavelength, what the air does to it, and what eyes make of it.
#pragma once

#include <array>

#include "core/math/vec3.h"

namespace tia {

/// Wavelengths: 380, 400 .. 780 nm.
inline constexpr std::size_t wavelengths = 21;
inline constexpr double first_nm = 380, step_nm = 20;

/// What a cubic metre of air at sea level scatters. Space/units: 1/m.
/// Source: Bodhaine, Wood, Dutton, Slusser, "On Rayleigh optical depth calculations", J. Atmos.
/// Ocean. Tech. 16 (1999), eq. 2 and 4 (Peck and Reeder's index), with one King factor.
double air_scattering(double nm);

/// Spectrum: what each wavelength meets, and what it counts.
struct Spectrum {
  std::array<double, wavelengths> air, ozone;  ///< taken away where each is thickest, 1/m
  std::array<Vec3d, wavelengths> light;  ///< the sun's above the air, of luminance 1 altogether
};
/// Of all of them, made once.
const Spectrum& spectrum();

}  // namespace tia
