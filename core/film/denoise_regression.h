// Light as a sum of multiples of features, around many centres.
#pragma once

#include <array>

#include "core/film/denoise_features.h"

namespace tia {

/// Irradiance: a half's light over its albedo, in planes of a grid, and what noise makes of it.
struct Irradiance {
  std::array<std::array<TilePlane, 3>, 2> halves;
  std::array<TilePlane, 3> variance;  ///< of each half
  TilePlane inside;                   ///< 1 in pixels of the window whose light is finite, else 0
};

/// FittedLight: what fits say of pixels. Shape: by half, by bandwidth (the wide one first): three
/// channels times their weights, summed, and the weights.
using FittedLight = std::array<std::array<std::array<TilePlane, 4>, 2>, 2>;

/// Fits each half's light with weights from the other one.
FittedLight fitted_light(const TileGrid& grid, const Irradiance& light,
                         const FeaturePlanes& features, const Workers& workers);

}  // namespace tia
