// Light without the colour of what it falls on.
#pragma once

#include <algorithm>
#include <array>

#include "core/film/denoise_tiles.h"
#include "core/film/pixel_planes.h"

namespace tia {

/// What light is divided by for an albedo and multiplied by again: not less than a twentieth, for
/// a glint on black is not to be all that counts.
inline float divisor_of(float albedo) { return std::max(albedo, 0.05F); }

/// Planes of a grid: the window's light over its albedo. Where that is not finite in a channel both
/// it and `inside` are 0.
std::array<TilePlane, 3> over_albedo(const TileGrid& grid, const PixelPlanes& pixels,
                                     TilePlane& inside, const Workers& workers);

/// 1 in the window, 0 beyond.
TilePlane window_of(const TileGrid& grid);

}  // namespace tia
