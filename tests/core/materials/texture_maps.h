// Pictures and maps of them, for tests of textures.
#pragma once

#include <memory>
#include <utility>

#include "core/materials/principled_maps.h"
#include "tests/core/support.h"

namespace tia::test {

/// Of random codes.
inline ImageRgba8 random_rgba(Random& random, int width, int height) {
  ImageRgba8 image{width, height, {}};
  image.rgba.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (auto& code : image.rgba) code = static_cast<std::uint8_t>(random.below(256));
  return image;
}
/// All of one colour.
inline ImageRgba8 even_rgba(int width, int height, const std::array<std::uint8_t, 4>& code) {
  ImageRgba8 image{width, height, {}};
  for (int i = 0; i < width * height; ++i)
    image.rgba.insert(image.rgba.end(), code.begin(), code.end());
  return image;
}

/// The codes of a pixel. Domain: inside the picture.
inline std::array<double, 4> codes_at(const ImageRgba8& image, int x, int y) {
  const auto at = 4 * static_cast<std::size_t>(y * image.width + x);
  return {image.rgba[at] / 255.0, image.rgba[at + 1] / 255.0, image.rgba[at + 2] / 255.0,
          image.rgba[at + 3] / 255.0};
}
/// IEC 61966-2-1.
inline double srgb_light(double code) {
  return code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
}

inline TextureMap texture_map(const ImageRgba8& image, Encoding encoding = Encoding::linear) {
  TextureMap map;
  map.pyramid =
      std::make_shared<const MipPyramid>(std::make_shared<const ImageRgba8>(image), encoding);
  return map;
}
/// At (u, v), v downward.
inline TexturePoint texture_point(double u, double v, double footprint = 0) {
  TexturePoint at;
  at.uv = {Vec2d{u, 1 - v}, Vec2d{u, 1 - v}};
  at.footprint = {footprint, footprint};
  return at;
}
inline void expect_rgba(const Rgba& got, const Rgba& expected, double most) {
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(got[k], expected[k], most) << "channel " << k;
}

}  // namespace tia::test
