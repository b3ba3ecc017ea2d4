// How far fits are trusted: no further than the noise of the picture itself may have led it away.
#pragma once

#include <array>

#include "core/film/denoise_regression.h"

namespace tia {

/// MeanLight: a picture as it is without a filter, in planes of a grid.
struct MeanLight {
  std::array<TilePlane, 3> light;   ///< over its albedo
  std::array<TilePlane, 3> albedo;  ///< by which it is multiplied again
  TilePlane variance;               ///< what noise makes of it, multiplied, all channels together
};

/// The mean of the halves.
MeanLight mean_light(const TileGrid& grid, const HalfBuffers& halves, const Irradiance& light);

/// The share, for each pixel, of the way from the picture's own light to what is fitted: less than
/// 1 where, around it, that is farther from it than noise explains, and a third more of it where
/// there is much. Then the fit is wrong by the rest, and the share is the one that leaves the least
/// squared error of the two. Errors are relative to the light around, so that a lamp's say nothing
/// of what it shines on. Where few pixels of many are so, chance explains that too, unless their
/// halves agree far better than noise lets them.
/// Source: Stein, "Estimation of the mean of a multivariate normal distribution" (1981).
TilePlane trust_in(const std::array<TilePlane, 3>& fits, const TileGrid& grid,
                   const MeanLight& picture, const TilePlane& inside);

}  // namespace tia
