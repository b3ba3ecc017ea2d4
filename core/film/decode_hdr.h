// Radiance's HDR in: linear light in four bytes a pixel.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "core/film/decode.h"

namespace tia {

/// RgbeImage: three mantissas and an exponent a pixel; a component is mantissa * 2^(exponent -
/// 136), and 0 where the exponent is 0. Shape: height x width, row 0 = top.
struct RgbeImage {
  int width = 0, height = 0;
  std::vector<std::array<std::uint8_t, 4>> pixels;
};

/// Whether a file begins as one of Radiance's.
bool is_hdr(std::span<const std::uint8_t> file);
/// Reads the header alone.
std::variant<PictureSize, PictureFault> measure_hdr(std::span<const std::uint8_t> file,
                                                    const PictureLimits& limits);
/// Rows from the top, pixels from the left, RGBE; run-length encoded by planes, in the old way, or
/// not at all. EXPOSURE and PRIMARIES are not undone. Cost: memory in proportion to the header's
/// pixels.
/// (stb_image 2.27 loops for ever over a file that ends within a row.)
/// Source: Ward, "Real pixels", Graphics Gems II (1991); Radiance's color.c and resolu.c.
std::variant<RgbeImage, PictureFault> decode_hdr(std::span<const std::uint8_t> file,
                                                 const PictureLimits& limits);

}  // namespace tia
