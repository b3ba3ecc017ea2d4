// What is seen of a picture after a sample or a few, filtered so that it can be looked at.
#pragma once

#include <algorithm>

#include "core/film/image.h"
#include "core/film/pixel_planes.h"
#include "core/parallel/workers.h"
#include "core/render/trace_tile.h"

namespace tia {

/// The number of the pixel in the middle of a pixel's block, of a tile that is cut into blocks of
/// that side.
inline int middle_of_block(const TilePixels& tile, int side, int pixel) {
  const auto middle = [side](int i, int end) {
    return std::min(i / side * side + side / 2, end - 1);
  };
  return middle(pixel / tile.width, tile.height) * tile.width +
         middle(pixel % tile.width, tile.width);
}

/// PreviewLight: of a window whose tiles are cut into blocks, of which the middle tells all.
class PreviewLight {
 public:
  static constexpr std::int64_t most_pixels = 1 << 20;  ///< that are worth the memory it takes

  /// Domain: a side by which tiles can be divided.
  PreviewLight(int width, int height, int side = 1);

  /// Takes what a tile's pixels have come to. Any thread may put tiles. Domain: pixels with guides.
  void put(const FilmTile& place, const TilePixels& pixels);
  /// Filters what there is (core/film/preview_filter.h), if that brings it nearer to what it is
  /// going to be: not where there is so little noise that the filter takes more off than that.
  const Image& filter(const Workers& workers);
  /// Shows its light in a tile, once it is filtered.
  void light(FilmTile& tile) const;

 private:
  bool has_come_nearer(const Image& filtered) const;

  int side_;
  PixelPlanes planes_;
  Image image_;
};

}  // namespace tia
