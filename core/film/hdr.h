// Radiance's HDR out: linear light in four bytes a pixel, unclamped.
#pragma once

#include <stop_token>
#include <string>

#include "core/film/image.h"

namespace tia {

/// The largest component that RGBE holds: all three mantissas 255, the exponent byte 255.
inline constexpr float largest_rgbe = 255.0F / 256 * 0x1p127F;

/// Returns: a file of stb_image_write's, rows top to bottom: three mantissas and one exponent a
/// pixel (RGBE), run-length encoded where a row has 8 to 32767 pixels. Same image, same bytes.
///
/// A pixel whose largest component lies in [2^(e-1), 2^e) keeps the multiples of 2^(e-8) at or
/// below its components: read as Ward does, half a step above, they are at most 1/256 of that
/// component off. Below 1e-32 it is 0. RGBE has no negative number and no infinity: negative
/// components and NaN are 0, what is above largest_rgbe is that.
/// Domain: at least one pixel, at most 2^28.
/// Errors: Stopped, if that is asked for before the encoding begins.
/// Source: G. Ward, Real Pixels, Graphics Gems II, 1991; Radiance's color.c for the run lengths.
std::string encode_hdr(Image image, const std::stop_token& stop = {});

}  // namespace tia
