// Pictures as video has them: luma, and differences of colour at a quarter of the places.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/film/image.h"

namespace tia {

/// YCbCr420: codes of BT.709 in the narrow range, Y' from 16 to 235, Cb and Cr from 16 to 240
/// about 128. Shape: `y` height x width; `cb`, `cr` ceil(height/2) x ceil(width/2).
struct YCbCr420 {
  int width = 0, height = 0;
  std::vector<std::uint8_t> y, cb, cr;

  int half_width() const { return (width + 1) / 2; }
  int half_height() const { return (height + 1) / 2; }
};

/// Y' = 16 + 219 (0.2126 R' + 0.7152 G' + 0.0722 B'), Cb = 128 + 224 (B' - Y) / 1.8556 and
/// Cr = 128 + 224 (R' - Y) / 1.5748, where R', G', B' are the codes / 255 as they are stored and Y
/// is the sum in the brackets; the latter two of the mean of 2 x 2 pixels, at an odd edge of those
/// there are. In integers, to half a code; greys are 128 exactly.
/// Source: ITU-R BT.709-6 (2015), items 3.2 to 3.4 of its table 3, and 4.6.
YCbCr420 ycbcr_of(const Image8& image);

}  // namespace tia
