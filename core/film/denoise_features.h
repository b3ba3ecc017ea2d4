// What rays find, with less noise: lenses, edges and soft shadows make it noisy, too.
#pragma once

#include <array>

#include "core/film/denoise_tiles.h"
#include "core/film/pixel_planes.h"

namespace tia {

/// FeaturePlanes: albedo, normal, depth and visibility over a grid. Shape: PixelPlanes' without
/// light.
using FeaturePlanes = std::array<TilePlane, PixelPlanes::count - PixelPlanes::albedo>;

/// The mean of the halves' features, each of the four filtered for itself by non-local means, one
/// half with the other one's weights. Where the halves agree, it is theirs, to the bit.
FeaturePlanes filtered_features(const TileGrid& grid, const HalfBuffers& halves,
                                const Workers& workers);

/// What noise makes of the numbers of one half: half the square of the halves' difference, the mean
/// over the square of that radius around each pixel.
TilePlane half_variance(const TileGrid& grid, const TilePlane& a, const TilePlane& b, int radius);

}  // namespace tia
