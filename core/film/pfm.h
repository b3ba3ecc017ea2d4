// PFM out: linear light in float, unclamped.
#pragma once

#include <span>
#include <stop_token>
#include <string>

#include "core/film/image.h"

namespace tia {

/// Returns: "PF", three channels, rows bottom to top, little-endian (scale -1).
/// Errors: Stopped. Source: P. Debevec, PFM Portable FloatMap Image Format.
std::string encode_pfm(const Image& image, const std::stop_token& stop = {});

/// The same of one channel: "Pf". Domain: width x height values, row by row from the top.
std::string encode_pfm(int width, int height, std::span<const float> values,
                       const std::stop_token& stop = {});

}  // namespace tia
