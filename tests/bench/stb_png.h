// stb_image_write's PNG as it comes, without the hook that the product puts behind it.
#pragma once

#include <cstddef>

#include "core/film/image.h"

namespace tia::bench {

/// Encodes the image and returns the file's bytes.
std::size_t stb_png_bytes(const Image8& image);

}  // namespace tia::bench
