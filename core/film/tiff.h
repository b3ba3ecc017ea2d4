// TIFF out: numbers in float, as they are.
#pragma once

#include <stop_token>
#include <string>

#include "core/film/image.h"

namespace tia {

/// Returns: a file of one image in one strip, uncompressed, little-endian, IEEE float, rows top to
/// bottom: of its first channel alone, or of all three, pixel by pixel. Infinity stays infinity.
/// Domain: channels 1 or 3; at most 2^24 pixels. Errors: Stopped.
/// Source: Adobe, TIFF Revision 6.0 (1992), sections 2, 4, 6 and 19.
std::string encode_tiff(const Image& image, int channels, const std::stop_token& stop = {});

}  // namespace tia
