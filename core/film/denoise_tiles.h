// Tiles of the denoiser: where they lie in a picture, and planes that have room around them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

#include "core/parallel/workers.h"

namespace tia {

/// TileGrid: whole tiles over a window of a picture. They begin at multiples of their size in the
/// picture, whatever the window: so what is summed tile by tile is summed in the same order.
/// Space/units: pixels from the first tile's corner.
struct TileGrid {
  static constexpr int tile = 32;
  static constexpr int radius = 8;  ///< how far off a pixel others count for it
  static constexpr int patch = 3;   ///< the radius of the patches by which pixels are compared
  /// Room around all tiles, for what looks beyond its own.
  static constexpr int usual_border = radius + patch + 1;

  TileGrid(int x0, int y0, int w, int h, int around = usual_border)
      : border(around),
        first_column(x0 / tile),
        first_row(y0 / tile),
        left(x0 % tile),
        top(y0 % tile),
        width(w),
        height(h) {}

  int border;
  int first_column, first_row;  ///< of the tiles of the picture
  int left, top;                ///< where the window begins
  int width, height;            ///< the window's

  int columns() const { return (left + width + tile - 1) / tile; }
  int rows() const { return (top + height + tile - 1) / tile; }
  std::size_t stride() const {
    const int across = columns() * tile + 2 * border;
    return static_cast<std::size_t>(across);
  }
  std::size_t size() const {
    return stride() * static_cast<std::size_t>(rows() * tile + 2 * border);
  }
  std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y + border) * stride() + static_cast<std::size_t>(x + border);
  }
  /// How far it is in a plane to the pixel at that offset.
  std::ptrdiff_t step(int dx, int dy) const {
    return dy * static_cast<std::ptrdiff_t>(stride()) + dx;
  }
};

/// TilePlane: a number for each pixel of a grid and of its border.
using TilePlane = std::vector<float>;

/// A plane over the grid of one over its window. Beyond the window its edge goes on.
TilePlane padded(const TileGrid& grid, const std::vector<float>& window);

/// The mean over the squares of that radius around each pixel. Domain: a radius within the border.
/// Returns: 0 so near the border's edge that the square would leave it.
TilePlane blurred(const TileGrid& grid, const TilePlane& plane, int radius);

/// Calls task(x, y) with the corners of all tiles, several at a time. `apart`: of no two tiles at a
/// time that touch each other, and of those that do in an order that depends on where they lie in
/// the picture alone.
void for_each_tile(const TileGrid& grid, const Workers& workers, bool apart,
                   const std::function<void(int x, int y)>& task);

}  // namespace tia
