// PNG and JPEG in: stb_image behind bounds, for what it is given comes from strangers.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>

#include "core/film/image.h"

namespace tia {

/// The most that a picture's file may hold: bytes, pixels, and scans of a JPEG, each of which goes
/// over all pixels again. A usual progressive file has ten; others need one, or one a component,
/// and may have some more in pictures that they carry.
inline constexpr std::size_t most_picture_bytes = 1 << 20;
inline constexpr std::int64_t most_picture_pixels = 1 << 22;
struct PictureLimits {
  std::size_t bytes = most_picture_bytes;
  std::int64_t pixels = most_picture_pixels;
};
inline constexpr int most_picture_scans = 64, most_sequential_scans = 8;

/// PictureSize: what a picture's headers say. Space/units: pixels.
struct PictureSize {
  int width = 0, height = 0;
  int scans = 0;            ///< of a JPEG, else 0
  bool progressive = true;  ///< else each scan of a JPEG also transforms what it reads
  std::int64_t pixels() const { return std::int64_t{width} * height; }
  /// What reading it costs. A JPEG is read in blocks of up to 32 x 32 pixels. Space/units: pixels
  /// of a progressive scan. Measured with the costliest files known, by what they have in blocks:
  /// 8 ns each, in a sequential scan 30.
  std::int64_t scanned_pixels() const {
    if (scans == 0) return pixels();
    const auto padded = [](int pixels) { return (std::int64_t{pixels} + 31) / 32 * 32; };
    return padded(width) * padded(height) * scans * (progressive ? 1 : 4);
  }
};

/// PictureFault: why a file is not decoded.
struct PictureFault {
  bool beyond_limits = false;  ///< else it is no picture, or a broken one
  std::string got, allowed;    ///< in words
};

/// Whether a file begins like a PNG or a JPEG.
bool is_picture(std::span<const std::uint8_t> file);

/// Why a file of so many bytes, or a picture of that size, is beyond the limits; none where it is
/// not.
std::optional<PictureFault> beyond(std::size_t file_bytes, const PictureLimits& limits);
std::optional<PictureFault> beyond(const PictureSize& size, const PictureLimits& limits);

/// Reads no more than the header. Cost: no memory to speak of.
std::variant<PictureSize, PictureFault> measure_picture(std::span<const std::uint8_t> file,
                                                        const PictureLimits& limits = {});

/// Returns: the picture's codes, without alpha; of 16 bits a channel the upper 8; grey as RGB. The
/// same bytes give the same codes on every machine, broken ones too.
/// Cost: memory in proportion to the header's pixels, whatever the file unpacks to.
/// Source: W3C PNG (third edition), ITU-T T.81, as far as stb_image 2.27 knows them; checksums are
/// not looked at.
std::variant<Image8, PictureFault> decode_picture(std::span<const std::uint8_t> file,
                                                  const PictureLimits& limits = {});
/// The same with alpha: 255 where the file has none; a PNG's transparent colour (tRNS) has 0.
std::variant<ImageRgba8, PictureFault> decode_picture_rgba(std::span<const std::uint8_t> file,
                                                           const PictureLimits& limits = {});

}  // namespace tia
