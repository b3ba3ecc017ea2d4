#include "core/film/denoise_features.h"

#include <algorithm>
#include <utility>

#include "core/film/denoise_weights.h"
#include "core/math/lanes.h"

namespace tia {
namespace {

constexpr int feature_reach = 5;  // how far off a pixel others count for its features
constexpr int feature_variance_radius = 2;

/// FeatureFilter: of one feature, of one number or three.
class FeatureFilter {
 public:
  FeatureFilter(const TileGrid& grid, const HalfBuffers& halves, std::size_t first,
                std::size_t count)
      : grid_(grid), count_(count) {
    for (std::size_t c = 0; c < count; ++c) {
      values_[0][c] = padded(grid, halves.a.planes[first + c]);
      values_[1][c] = padded(grid, halves.b.planes[first + c]);
      variances_[c] = half_variance(grid, values_[0][c], values_[1][c], feature_variance_radius);
      means_[c] = mean(values_[0][c], values_[1][c]);
    }
  }

  // Pixels of a tile are written by none but its task.
  std::array<TilePlane, 3> operator()(const Workers& workers) {
    const auto is_exact = [](const TilePlane& variance) {
      return std::ranges::all_of(variance, [](float each) { return each == 0; });
    };
    if (!std::all_of(variances_.begin(), variances_.begin() + std::ptrdiff_t(count_), is_exact))
      for_each_tile(grid_, workers, false, [this](int x, int y) { filter(x, y); });
    return std::move(means_);
  }

 private:
  static constexpr int tile = TileGrid::tile;
  using Rows = std::array<std::array<float, tile>, tile>;
  /// Sums: over the pixels around those of a tile: weights, and what these make of differences.
  struct Sums {
    Rows weight{};
    std::array<Rows, 3> change{};
  };

  static TilePlane mean(const TilePlane& a, const TilePlane& b) {
    TilePlane both(a.size());
    std::ranges::transform(a, b, both.begin(), [](float u, float v) { return (u + v) * 0.5F; });
    return both;
  }

  void filter(int x, int y) {
    for (std::size_t half = 0; half < 2; ++half) {
      Sums sums;
      PatchDistances compare(grid_, guide(1 - half), x, y);
      Rows distances;
      for (int dy = -feature_reach; dy <= feature_reach; ++dy)
        for (int dx = -feature_reach; dx <= feature_reach; ++dx) {
          compare.of_all(dx, dy, distances);
          add(half, x, y, grid_.step(dx, dy), distances, sums);
        }
      change(x, y, sums);
    }
  }
  Guide guide(std::size_t half) const {
    Guide guide{static_cast<int>(count_)};
    for (std::size_t c = 0; c < count_; ++c) {
      guide.value[c] = values_[half][c].data();
      guide.variance[c] = variances_[c].data();
    }
    return guide;
  }
  void add(std::size_t half, int x, int y, std::ptrdiff_t step, Rows& distances, Sums& sums) const {
    for (std::size_t row = 0; row < tile; ++row) {
      std::array<float, tile>& weight = distances[row];
      for (std::size_t i = 0; i < tile; i += Wide::size)
        store(wide_weight(load<Wide>(&weight[i])), &weight[i]);
      for (std::size_t i = 0; i < tile; ++i) sums.weight[row][i] += weight[i];
      const std::size_t at = grid_.at(x, y + static_cast<int>(row));
      for (std::size_t c = 0; c < count_; ++c) {
        const float *here = values_[half][c].data() + at, *there = here + step;
        std::array<float, tile>& to = sums.change[c][row];
        for (std::size_t i = 0; i < tile; ++i) to[i] += weight[i] * (there[i] - here[i]);
      }
    }
  }
  // Half of what the half changes by, for the mean is that of both.
  void change(int x, int y, const Sums& sums) {
    for (int row = 0; row < tile; ++row)
      for (int column = 0; column < tile; ++column) {
        const std::size_t at = grid_.at(x + column, y + row);
        const auto i = static_cast<std::size_t>(column), j = static_cast<std::size_t>(row);
        float variance = 0;
        for (std::size_t c = 0; c < count_; ++c) variance += variances_[c][at];
        if (!(variance > 0)) continue;
        for (std::size_t c = 0; c < count_; ++c)
          means_[c][at] += 0.5F * sums.change[c][j][i] / sums.weight[j][i];
      }
  }

  const TileGrid& grid_;
  std::size_t count_;
  std::array<std::array<TilePlane, 3>, 2> values_;  // of each half
  std::array<TilePlane, 3> variances_, means_;
};

// The planes of a grid hold what is right within its window alone.
TilePlane padded_again(const TileGrid& grid, const TilePlane& plane) {
  std::vector<float> window;
  window.reserve(static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height));
  for (int y = 0; y < grid.height; ++y) {
    const float* row = plane.data() + grid.at(grid.left, grid.top + y);
    window.insert(window.end(), row, row + grid.width);
  }
  return padded(grid, window);
}

}  // namespace

TilePlane half_variance(const TileGrid& grid, const TilePlane& a, const TilePlane& b, int radius) {
  TilePlane squares(a.size());
  std::ranges::transform(a, b, squares.begin(),
                         [](float u, float v) { return (u - v) * (u - v) * 0.5F; });
  return blurred(grid, squares, radius);
}

FeaturePlanes filtered_features(const TileGrid& grid, const HalfBuffers& halves,
                                const Workers& workers) {
  constexpr std::size_t albedo = PixelPlanes::albedo, normal = PixelPlanes::normal,
                        depth = PixelPlanes::depth, visibility = PixelPlanes::visibility;
  FeaturePlanes features;
  const auto filter = [&](std::size_t first, std::size_t count) {
    std::array<TilePlane, 3> filtered = FeatureFilter(grid, halves, first, count)(workers);
    for (std::size_t c = 0; c < count; ++c)
      features[first - albedo + c] = padded_again(grid, filtered[c]);
  };
  filter(albedo, 3);
  filter(normal, 3);
  filter(depth, 1);
  filter(visibility, 1);
  return features;
}

}  // namespace tia
