// The filter of previews: what is there after a sample or a few, made to look at, within
// milliseconds. It tells less than the denoiser and blurs more.
#pragma once

#include "core/film/image.h"
#include "core/film/pixel_planes.h"
#include "core/parallel/workers.h"

namespace tia {

/// The picture's light, smoothed where what rays have found is alike: in five passes each pixel
/// takes the weighted mean of 13 around, 1, 2, 4, 8 and 16 pixels apart, the light over albedo.
/// Weights fall with what normal, depth, visibility and light differ by, light counting more from
/// pass to pass.
/// Returns: the same for any workers.
/// Source: Dammertz, Sewtz, Hanika, Lensch, "Edge-avoiding a-trous wavelet transform for fast
/// global illumination filtering" (2010).
Image preview(const PixelPlanes& pixels, const Workers& workers = {});

}  // namespace tia
