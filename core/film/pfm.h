// PFM out: linear light in float, unclamped.
#pragma once

#include <string>

#include "core/film/image.h"

namespace tia {

/// Returns: "PF", three channels, rows bottom to top, little-endian (scale -1).
/// Source: P. Debevec, PFM Portable FloatMap Image Format.
std::string encode_pfm(const Image& image);

}  // namespace tia
