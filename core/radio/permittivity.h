// What a radio material is at a frequency: its relative permittivity, complex where it is lossy.
#pragma once

#include <optional>
#include <string>

#include "core/materials/radio_material.h"
#include "core/radio/complex.h"
#include "core/radio/constants.h"

namespace tia {

/// RadioMatter: a material at one frequency.
/// Space/units: e^{+j omega t}: losses are below the real axis; thickness in metres.
struct RadioMatter {
  enum Kind { dielectric, conductor, air } kind = dielectric;
  Complex eta{1, 0};
  std::optional<double> thickness;
  bool through = false;
};
/// Source: eta of rows: Recommendation ITU-R P.2040-3, (28) and (29); eta' - j sigma/(omega eps0).
RadioMatter matter_of(const RadioMaterial& material, const Wave& wave);

/// What is to be told of a material that is asked for outside the band in which it was measured;
/// else "".
std::string band_warning(const RadioMaterial& material, const Wave& wave);

}  // namespace tia
