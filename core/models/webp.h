// WebP in: libwebp's decoder behind bounds, as decode.h has PNG and JPEG.
#pragma once

#include <variant>

#include "core/film/decode.h"
#include "core/models/model_files.h"

namespace tia {

/// Whether a file begins like a WebP.
bool is_webp(ModelBytes file);

/// Reads no more than the header. An animation is refused. Cost: no memory.
std::variant<PictureSize, PictureFault> measure_webp(ModelBytes file,
                                                     const PictureLimits& limits = {});

/// Returns: the picture's codes; alpha is 255 where the file has none.
/// Errors: std::bad_alloc where libwebp found no memory.
/// Cost: memory in proportion to the header's pixels, and up to 0.8 GB for a lossless picture's
/// tables of codes, which are no more than 65 536.
/// Source: RFC 9649, as libwebp 1.2.4 reads it.
std::variant<ImageRgba8, PictureFault> decode_webp(ModelBytes file,
                                                   const PictureLimits& limits = {});

}  // namespace tia
