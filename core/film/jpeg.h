// JPEG out: what live pictures are sent as. By libjpeg-turbo.
#pragma once

#include <string>

#include "core/film/image.h"

namespace tia {

/// Returns: a JPEG file (JFIF, baseline, 8 bits), quality 90 of 100, colours at every pixel
/// (4:4:4). Same image, same bytes: of libjpeg's transforms the integer one, which is the same with
/// and without a processor's vector instructions. Domain: sides from 1 to longest_jpeg_side pixels.
/// Errors: std::bad_alloc. Source: ITU-T T.81 (1992); JFIF 1.02 (1992).
std::string encode_jpeg(const Image8& image);

inline constexpr int longest_jpeg_side = 65'500;

}  // namespace tia
