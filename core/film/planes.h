// Planes: what is known of a picture's pixels, one plane of floats for each number.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "core/film/image.h"

namespace tia {

/// Planes: Shape: count x height x width, row 0 on top. It is a film: tiles never overlap.
class Planes {
 public:
  Planes(int width, int height, int count)
      : width_(width), height_(height), values_(area() * static_cast<std::size_t>(count)) {}

  int width() const { return width_; }
  int height() const { return height_; }
  /// Row y of a plane.
  const float* row(int plane, int y) const { return values_.data() + offset(plane, y); }
  /// Copies a plane of a tile.
  void put(const FilmTile& tile, std::span<const float> from, int plane) {
    for (int y = 0; y < tile.height; ++y)
      std::copy_n(from.data() + FilmTile::index(0, y), tile.width,
                  values_.data() + offset(plane, tile.y + y) + tile.x);
  }

 private:
  std::size_t area() const {
    return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  }
  std::size_t offset(int plane, int y) const {
    return static_cast<std::size_t>(plane) * area() +
           static_cast<std::size_t>(y) * static_cast<std::size_t>(width_);
  }

  int width_, height_;
  std::vector<float> values_;
};

}  // namespace tia
