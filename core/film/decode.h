// PNG and JPEG in: stb_image behind bounds, for what it is given comes from strangers.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <variant>

#include "core/film/image.h"

namespace tia {

/// The most that a picture's file may hold: bytes, pixels, and scans of a JPEG (each goes over all
/// pixels again; a usual progressive file has ten).
inline constexpr std::size_t most_picture_bytes = 1 << 20;
inline constexpr std::int64_t most_picture_pixels = 1 << 22;
inline constexpr int most_picture_scans = 64;

/// PictureSize: what a picture's headers say. Space/units: pixels.
struct PictureSize {
  int width = 0, height = 0;
  int scans = 1;  ///< of a JPEG
  std::int64_t pixels() const { return std::int64_t{width} * height; }
  /// What reading it goes over.
  std::int64_t scanned_pixels() const { return pixels() * scans; }
};

/// PictureFault: why a file is not decoded.
struct PictureFault {
  bool beyond_limits = false;  ///< else it is no picture, or a broken one
  std::string got, allowed;    ///< in words
};

/// Reads no more than the header. Cost: no memory to speak of.
std::variant<PictureSize, PictureFault> measure_picture(std::span<const std::uint8_t> file);

/// Returns: the picture's codes, without alpha; of 16 bits a channel the upper 8; grey as RGB. The
/// same bytes give the same codes on every machine, broken ones too.
/// Cost: memory in proportion to the header's pixels, whatever the file unpacks to.
/// Source: W3C PNG (third edition), ITU-T T.81, as far as stb_image 2.27 knows them; checksums are
/// not looked at.
std::variant<Image8, PictureFault> decode_picture(std::span<const std::uint8_t> file);

}  // namespace tia
