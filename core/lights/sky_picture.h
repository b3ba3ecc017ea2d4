// SkyPicture: a picture of all that is around, by latitude and longitude.
#pragma once

#include <span>
#include <variant>

#include "core/film/decode_hdr.h"
#include "core/film/image.h"
#include "core/math/heap.h"
#include "core/math/vec3.h"

namespace tia {

/// The most that the file of one may hold: 8 MiB, and 4096 x 2048 pixels.
inline constexpr std::size_t most_sky_bytes = 8 << 20;
inline constexpr std::int64_t most_sky_pixels = 1 << 23;
inline constexpr PictureLimits sky_picture_limits{most_sky_bytes, most_sky_pixels};

/// SkyPicture: its texels, as they came. Shape: height x width, row 0 = the zenith's.
struct SkyPicture {
  std::variant<Image8, RgbeImage> image;

  int width() const;
  int height() const;
  /// Linear RGB; of a PNG's or JPEG's codes by the curve of sRGB. Domain: 0 <= x < width, 0 <= y <
  /// height.
  Vec3f texel(int x, int y) const;
};
/// Space/units: bytes.
std::size_t heap_bytes(const SkyPicture& picture);

/// Reads the header alone. Beside what PNG, JPEG and Radiance's HDR may be wrong in: what is not
/// twice as wide as high.
std::variant<PictureSize, PictureFault> measure_sky(std::span<const std::uint8_t> file);
/// Also wrong: texels above 1e9.
std::variant<SkyPicture, PictureFault> decode_sky(std::span<const std::uint8_t> file);

}  // namespace tia
