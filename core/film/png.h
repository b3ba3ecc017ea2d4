// PNG out: stb_image_write's container with libdeflate behind its compression hook; of large
// pictures a container of our own around strips that are compressed in parallel.
#pragma once

#include <stop_token>
#include <string>

#include "core/film/image.h"
#include "core/film/scanlines.h"
#include "core/parallel/workers.h"

namespace tia {

/// Returns: a PNG file, RGB, 8 bits a channel. Same image, same bytes.
/// Source: W3C PNG (third edition). Filter Sub on every row and libdeflate level 2: a quarter of
/// stb's own time and smaller.
/// Domain: at least one pixel, at most 2^28.
/// Errors: Stopped, if that is asked for before the compression begins.
std::string encode_png(const Image8& image, const std::stop_token& stop = {});

/// The same with alpha: RGBA.
std::string encode_png(const ImageRgba8& image, const std::stop_token& stop = {});

/// Whether a picture is compressed in strips: with more than 1 MiB of scanlines. Below, one thread
/// takes longer over strips than over the whole.
bool is_cut_in_strips(int width, int height);

/// Returns: a PNG file of filtered scanlines. Same scanlines, same bytes, whoever works on it:
/// all strips but the last are of one size, each a chunk of libdeflate level 2 like the picture
/// above. They know nothing of one another, for which the file is about 1 % larger. Errors: what
/// the workers throw.
std::string encode_png(const Scanlines& scanlines, const Workers& workers = {});

/// The encoder's name and version, for the bytes depend on it: "libdeflate 1.14".
std::string png_encoder();

}  // namespace tia
