// The denoiser: from two half buffers of a noisy picture and of what its rays found to a picture
// with less noise. Nothing is learned and nothing can be set.
#pragma once

#include "core/film/image.h"
#include "core/film/pixel_planes.h"
#include "core/parallel/workers.h"

namespace tia {

/// How far off a pixel what decides it may be: of a window that is so much larger on every side
/// where the picture goes on, the inner part is that of the whole picture, bit for bit.
/// Space/units: pixels.
inline constexpr int denoise_margin = 36;

/// The picture's light with less noise. Albedo is divided out; features are filtered by non-local
/// means, each half with weights from the other one; around every second pixel of every second row
/// light is fitted, by weighted least squares, as a sum of a constant and of multiples of the
/// features and of the place, which a smooth gradient has none to tell by; what such a fit says of
/// all pixels around is averaged. Of two bandwidths of the weights the one counts by which either
/// half tells the other one better. Where that is farther from the samples' mean than their noise
/// explains, it is taken but for a share (denoise_trust.h).
/// Returns: the same for any workers.
///
/// Cost: some 10 000 multiplications a pixel.
///
/// Source: Bitterli, Rousselle, Moon, Iglesias-Guitian, Adler, Mitchell, Jarosz, Novak,
/// "Nonlinearly weighted first-order regression for denoising Monte Carlo renderings" (2016); the
/// weights: Rousselle, Knaus, Zwicker, "Adaptive rendering with non-local means filtering" (2012).
Image denoise(const HalfBuffers& halves, const Workers& workers = {});

}  // namespace tia
