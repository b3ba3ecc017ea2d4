// PNG out: stb_image_write's container with libdeflate behind its compression hook.
#pragma once

#include <stop_token>
#include <string>

#include "core/film/image.h"

namespace tia {

/// Returns: a PNG file, RGB, 8 bits a channel. Same image, same bytes.
/// Source: W3C PNG (third edition). Filter Sub on every row and libdeflate level 2: a quarter of
/// stb's own time and smaller.
/// Domain: at least one pixel, at most 2^28.
/// Errors: Stopped, if that is asked for before the compression begins.
std::string encode_png(const Image8& image, const std::stop_token& stop = {});

/// The encoder's name and version, for the bytes depend on it: "libdeflate 1.14".
std::string png_encoder();

}  // namespace tia
