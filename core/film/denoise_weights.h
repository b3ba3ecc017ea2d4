// How alike the patches around two pixels are, but for noise.
#pragma once

#include <array>
#include <cstddef>

#include "core/film/denoise_tiles.h"
#include "core/math/wide.h"

namespace tia {

/// Guide: the numbers by which pixels are compared, at most three a pixel, and the variances that
/// noise gives them. Shape: planes of a grid.
struct Guide {
  int count = 0;
  std::array<const float*, 3> value{}, variance{};
};

/// PatchDistances: of a tile's pixels to those at an offset: the mean, over the square patches
/// around the two, of the squares of what their numbers differ by, less what noise makes of that,
/// over the variance of that difference. Of patches that differ by noise alone it is about 0; never
/// below. Source: Rousselle, Knaus, Zwicker (2012), equation 2.
class PatchDistances {
 public:
  static constexpr int tile = TileGrid::tile;
  static constexpr int centers = tile / 2;  ///< every second pixel of every second row

  PatchDistances(const TileGrid& grid, const Guide& guide, int x, int y)
      : grid_(grid), guide_(guide), x_(x), y_(y) {}

  /// Of each pixel of the tile.
  void of_all(int dx, int dy, std::array<std::array<float, tile>, tile>& distances);
  /// Of the centres.
  void of_centers(int dx, int dy, std::array<std::array<float, centers>, centers>& distances);

 private:
  static constexpr int patch = TileGrid::patch;
  static constexpr int width = tile + 8, height = tile + 2 * patch;
  using Row = std::array<float, width>;
  void compare(int dx, int dy);
  void compare_row(std::size_t p, std::size_t q, Row& to) const;
  Row column_sums(int y) const;

  const TileGrid& grid_;
  Guide guide_;
  int x_, y_;
  std::array<Row, height> rows_;
};

/// The weights that pixels of such distances have, by the wider of two bandwidths, and by half of
/// it: e^-d and e^-4d, but for powers in their place, which are 0 from 8 on.
template <class Real>
Real wide_weight(const Real& distance) {
  const Real t = max_of(Real(1) - distance * Real(0.125F), Real(0)), v = t * t, w = v * v;
  return w * w;
}
template <class Real>
Real narrow_weight(const Real& wide) {
  const Real w = wide * wide;
  return w * w;
}

}  // namespace tia
