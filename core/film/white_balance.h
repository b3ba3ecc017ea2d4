// White balance: light of one temperature made neutral.
#pragma once

#include "core/math/transform.h"

namespace tia {

/// The white of that temperature: a black body's up to 4000 K, daylight's from 5000 K on, between
/// them their mixture, as CIE 224:2017 (ANSI/IES TM-30) has its reference.
/// Space/units: kelvin; CIE 1931 XYZ, Y = 1. Domain: 1000 .. 25000.
/// Source: black body: M. Krystek, "An algorithm to calculate correlated colour temperature", Color
/// Research and Application 10 (1985), within 4e-4 of x and y; daylight: CIE 15:2004, 3.1.
Vec3d white_point(double kelvin);

/// What makes the white of that temperature sRGB's own, of the same luminance: von Kries' gains on
/// Bradford's responses of the eye. Space/units: linear sRGB to linear sRGB. Domain: as above.
/// Source: K. M. Lam, "Metamerism and colour constancy" (1985); ICC.1:2010, annex E.
Affine white_balance(double kelvin);

}  // namespace tia
