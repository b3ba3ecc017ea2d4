// A picture as the tiles that come to a film.
#pragma once

#include "tests/core/support.h"

namespace tia::test {

/// A picture cut into tiles of a side.
inline std::vector<FilmTile> tiles_of(const Image& image, int side) {
  std::vector<FilmTile> tiles;
  for (int y0 = 0; y0 < image.height; y0 += side) {
    for (int x0 = 0; x0 < image.width; x0 += side) {
      FilmTile& tile = tiles.emplace_back();
      tile.x = x0;
      tile.y = y0;
      tile.width = std::min(side, image.width - x0);
      tile.height = std::min(side, image.height - y0);
      for (int y = 0; y < tile.height; ++y) {
        for (int x = 0; x < tile.width; ++x) {
          const float* from = image.at(x0 + x, y0 + y);
          const std::size_t i = FilmTile::index(x, y);
          tile.r[i] = from[0];
          tile.g[i] = from[1];
          tile.b[i] = from[2];
        }
      }
    }
  }
  return tiles;
}

}  // namespace tia::test
