// How plane waves are reflected by half spaces and sheets, and go through them.
#pragma once

#include "core/radio/complex.h"
#include "core/radio/constants.h"

namespace tia {

/// Polarized: a factor for the field perpendicular to the plane of incidence (TE), and one for the
/// field in it (TM).
struct Polarized {
  Complex perpendicular, parallel;
};

/// What a perfect conductor reflects: the limit of half_space for eta to infinity.
inline constexpr Polarized mirrored{{-1, 0}, {1, 0}};

/// What a half space of relative permittivity eta reflects; `cosine` of the angle from the normal.
/// Domain: 0 <= cosine <= 1; a real part of eta >= 1, an imaginary one <= 0.
/// Source: Recommendation ITU-R P.2040-3, (37).
Polarized half_space(const Complex& eta, double cosine);

/// The same where a wave goes in or out: the root of t12 t21 = 1 - r^2, so that both ends of a way
/// through a body come to that, whichever way it is gone.
Polarized half_space_through(const Complex& eta, double cosine);

/// How much slower than empty space a body turns the phase, and what it absorbs: q - cos, q the
/// root of eta - sin^2. A layer of thickness d leaves e^{-j k d (q - cos)} of a wave that goes
/// straight on.
Complex excess_of(const Complex& eta, double cosine);

/// SheetFactors: what a sheet reflects, and what goes through it, referred to the undisturbed ray.
struct SheetFactors {
  Polarized reflected, transmitted;
};
/// Of a sheet of that thickness in metres. Source: P.2040-3, (43): the single slab.
SheetFactors sheet(const Complex& eta, double cosine, double thickness, const Wave& wave);

}  // namespace tia
