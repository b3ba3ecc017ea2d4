// Pixels: linear light in float, and 8-bit codes. Row 0 is the top.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/math/vec3.h"

namespace tia {

/// FilmTile: a finished rectangle of linear RGB on its way to a film, at most 32 x 32.
/// Shape: three planes of `size` rows of `size` floats, of which width x height count.
/// Space/units: pixels; x, y is the tile's corner in the film.
struct FilmTile {
  static constexpr int size = 32;
  static constexpr std::size_t index(int column, int row) {
    return static_cast<std::size_t>(row) * size + static_cast<std::size_t>(column);
  }
  int x = 0, y = 0, width = 0, height = 0;
  alignas(32) std::array<float, std::size_t{size} * size> r, g, b;
  /// The share of a pixel that objects cover, by which its light is multiplied already; only of
  /// worlds with a backdrop, else not set.
  std::array<float, std::size_t{size} * size> alpha;
  /// Further planes, one behind another, each as r: of layers, where there are any (LayerFilm).
  std::vector<float> more = {};

  std::span<const float> more_plane(int i) const {
    return std::span(more).subspan(static_cast<std::size_t>(i) * r.size(), r.size());
  }
};

/// Replaces each pixel of a tile by what f makes of it.
template <class F>
void for_each_pixel(FilmTile& tile, F f) {
  for (int y = 0; y < tile.height; ++y) {
    const std::size_t row = FilmTile::index(0, y);
    for (std::size_t i = row; i < row + static_cast<std::size_t>(tile.width); ++i) {
      const Vec3f made = f(Vec3f{tile.r[i], tile.g[i], tile.b[i]});
      tile.r[i] = made.x;
      tile.g[i] = made.y;
      tile.b[i] = made.z;
    }
  }
}

/// Image: linear RGB. Shape: height x width x 3.
struct Image {
  int width = 0, height = 0;
  std::vector<float> rgb;

  Image() = default;
  Image(int w, int h)
      : width(w), height(h), rgb(3 * static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}
  /// The three components of pixel (x, y).
  float* at(int x, int y) { return rgb.data() + offset(x, y); }
  const float* at(int x, int y) const { return rgb.data() + offset(x, y); }

 private:
  std::size_t offset(int x, int y) const {
    return 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                static_cast<std::size_t>(x));
  }
};

/// Image8: what a PNG holds. Shape: height x width x 3 codes 0..255.
struct Image8 {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;

  Image8() = default;
  Image8(int w, int h)
      : width(w), height(h), rgb(3 * static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}
};

/// ImageRgba8: codes with alpha, which is not multiplied into the colours. Shape: height x width x
/// 4 codes 0..255.
struct ImageRgba8 {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

}  // namespace tia
