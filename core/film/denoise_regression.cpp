#include "core/film/denoise_regression.h"

#include <memory>

#include "core/film/denoise_fit.h"
#include "core/math/lanes.h"

namespace tia {
namespace {

constexpr std::size_t around_tile = TileGrid::tile + 2 * TileGrid::radius;  // what its centres see
constexpr std::size_t offsets_around = (2 * TileGrid::radius + 1) * (2 * TileGrid::radius + 1);
static_assert(TileGrid::radius % 2 == 0);

/// SplitPlane: a tile and what is around, its even columns and its odd ones apart: so what lies at
/// an offset from the centres of a row stands side by side.
template <class Number>
struct SplitPlane {
  std::array<std::array<std::array<Number, around_tile / 2>, 2>, around_tile> rows{};

  // The first of as many as there are lanes. Domain: a row of centres of the tile.
  const Number* at(int row, int dx, int dy) const { return place(*this, row, dx, dy); }
  Number* at(int row, int dx, int dy) { return place(*this, row, dx, dy); }

 private:
  static constexpr int radius = TileGrid::radius;
  static auto place(auto& self, int row, int dx, int dy) {
    const auto y = static_cast<std::size_t>(2 * row + dy + radius);
    const auto x = static_cast<std::size_t>(dx + radius);
    return self.rows[y][x % 2].data() + x / 2;
  }
};

/// TileFits: the fits of one tile's centres.
class TileFits {
 public:
  TileFits(const TileGrid& grid, const Irradiance& light, const FeaturePlanes& features, int x,
           int y)
      : grid_(grid), x_(x), y_(y) {
    for (std::size_t j = 3; j < features.size(); ++j) copy(features[j], features_[j - 2]);
    copy_mean(features);
    for (std::size_t half = 0; half < 2; ++half)
      for (std::size_t c = 0; c < 3; ++c) copy(light.halves[half][c], light_[half][c]);
    copy(light.inside, inside_);
    for (std::size_t half = 0; half < 2; ++half) compare(light, half);
  }

  void add_to(FittedLight& sums) {
    for (std::size_t half = 0; half < 2; ++half)
      for (std::size_t narrow = 0; narrow < 2; ++narrow) {
        told_ = {};
        for (int row = 0; row < PatchDistances::centers; ++row) fit(half, narrow == 1, row);
        for (std::size_t c = 0; c < 4; ++c) add(told_[c], sums[half][narrow][c]);
      }
  }

 private:
  static constexpr int radius = TileGrid::radius;
  static constexpr std::size_t lanes = CenterFits::lanes, terms = CenterFits::terms;
  using Lanes = CenterFits::Lanes;
  using Terms = CenterFits::Terms;
  using Channels = CenterFits::Channels;
  using Weights = std::array<std::array<float, lanes>, offsets_around>;

  void copy(const TilePlane& plane, SplitPlane<float>& to) const {
    for (std::size_t y = 0; y < around_tile; ++y) {
      const float* row = plane.data() + grid_.at(x_ - radius, y_ - radius + static_cast<int>(y));
      for (std::size_t x = 0; x < around_tile; ++x) to.rows[y][x % 2][x / 2] = row[x];
    }
  }
  // Light over albedo has little to do with its hue: one number tells of it.
  void copy_mean(const FeaturePlanes& features) {
    SplitPlane<float> green, blue;
    copy(features[0], features_[0]);
    copy(features[1], green);
    copy(features[2], blue);
    for (std::size_t y = 0; y < around_tile; ++y)
      for (std::size_t x = 0; x < around_tile; ++x) {
        float& red = features_[0].rows[y][x % 2][x / 2];
        red = (red + green.rows[y][x % 2][x / 2] + blue.rows[y][x % 2][x / 2]) / 3;
      }
  }
  void add(const SplitPlane<double>& told, TilePlane& plane) const {
    for (std::size_t y = 0; y < around_tile; ++y) {
      float* row = plane.data() + grid_.at(x_ - radius, y_ - radius + static_cast<int>(y));
      for (std::size_t x = 0; x < around_tile; ++x)
        row[x] += static_cast<float>(told.rows[y][x % 2][x / 2]);
    }
  }

  // The weights that a half gives, which are for the other one.
  void compare(const Irradiance& light, std::size_t half) {
    Guide guide{3};
    for (std::size_t c = 0; c < 3; ++c) {
      guide.value[c] = light.halves[half][c].data();
      guide.variance[c] = light.variance[c].data();
    }
    PatchDistances compare(grid_, guide, x_, y_);
    std::array<std::array<float, lanes>, PatchDistances::centers> distances;
    for_each_offset([&](int dx, int dy, std::size_t offset) {
      compare.of_centers(dx, dy, distances);
      for (int row = 0; row < PatchDistances::centers; ++row) {
        const auto r = static_cast<std::size_t>(row);
        const float *here = inside_.at(row, 0, 0), *there = inside_.at(row, dx, dy);
        for (std::size_t i = 0; i < lanes; i += Wide::size)
          store(wide_weight(load<Wide>(&distances[r][i])) *
                    (load<Wide>(here + i) * load<Wide>(there + i)),
                &weights_[1 - half][r][offset][i]);
      }
    });
  }
  template <class F>
  static void for_each_offset(const F& f) {
    std::size_t offset = 0;
    for (int dy = -radius; dy <= radius; ++dy)
      for (int dx = -radius; dx <= radius; ++dx) f(dx, dy, offset++);
  }

  // One row of centres.
  void fit(std::size_t half, bool narrow, int row) {
    const Weights& weights = weights_[half][static_cast<std::size_t>(row)];
    CenterFits fits;
    for_each_weighted(weights, narrow, [&](int dx, int dy, const Lanes& weight) {
      fits.add(weight, terms_at(row, dx, dy), light_at(half, row, dx, dy));
    });
    const std::array<Channels, terms> factors = fits.solved(scale_at(row));
    for_each_weighted(weights, narrow, [&](int dx, int dy, const Lanes& weight) {
      tell(factors, terms_at(row, dx, dy), weight, row, dx, dy);
    });
  }
  // Calls f but where all weights are 0.
  template <class F>
  static void for_each_weighted(const Weights& weights, bool narrow, const F& f) {
    for_each_offset([&](int dx, int dy, std::size_t offset) {
      Lanes weight;
      float all = 0;
      for (std::size_t i = 0; i < lanes; ++i) {
        const float wide = weights[offset][i], own = narrow ? narrow_weight(wide) : wide;
        all += own;
        weight[i] = static_cast<double>(own);
      }
      if (all > 0) f(dx, dy, weight);
    });
  }
  Terms terms_at(int row, int dx, int dy) const {
    Terms x;
    x[0].fill(1);
    x[terms - 2].fill(static_cast<double>(dx) / radius);
    x[terms - 1].fill(static_cast<double>(dy) / radius);
    for (std::size_t j = 1; j <= features_.size(); ++j) {
      const float *here = features_[j - 1].at(row, 0, 0), *there = features_[j - 1].at(row, dx, dy);
      for (std::size_t i = 0; i < lanes; ++i)
        x[j][i] = static_cast<double>(there[i]) - static_cast<double>(here[i]);
    }
    return x;
  }
  Channels light_at(std::size_t half, int row, int dx, int dy) const {
    Channels y;
    for (std::size_t c = 0; c < 3; ++c) {
      const float* there = light_[half][c].at(row, dx, dy);
      for (std::size_t i = 0; i < lanes; ++i) y[c][i] = static_cast<double>(there[i]);
    }
    return y;
  }
  // A depth counts for what it is, the others are in 0 to 1 or about it.
  Terms scale_at(int row) const {
    constexpr std::size_t depth = PixelPlanes::depth - PixelPlanes::albedo - 1;
    Terms scale;
    for (Lanes& each : scale) each.fill(1);
    const float* here = features_[depth - 1].at(row, 0, 0);
    for (std::size_t i = 0; i < lanes; ++i) scale[depth][i] = static_cast<double>(here[i]);
    return scale;
  }
  void tell(const std::array<Channels, terms>& factors, const Terms& x, const Lanes& weight,
            int row, int dx, int dy) {
    for (std::size_t c = 0; c < 3; ++c) {
      Lanes told = factors[0][c];
      for (std::size_t j = 1; j < terms; ++j)
        for (std::size_t i = 0; i < lanes; ++i) told[i] += factors[j][c][i] * x[j][i];
      double* to = told_[c].at(row, dx, dy);
      for (std::size_t i = 0; i < lanes; ++i) to[i] += weight[i] * told[i];
    }
    double* to = told_[3].at(row, dx, dy);
    for (std::size_t i = 0; i < lanes; ++i) to[i] += weight[i];
  }

  const TileGrid& grid_;
  int x_, y_;
  std::array<SplitPlane<float>, terms - 3> features_;  // albedo's mean, normal, depth, visibility
  std::array<std::array<SplitPlane<float>, 3>, 2> light_;
  SplitPlane<float> inside_;
  std::array<std::array<Weights, PatchDistances::centers>, 2> weights_;
  std::array<SplitPlane<double>, 4> told_;
};

}  // namespace

FittedLight fitted_light(const TileGrid& grid, const Irradiance& light,
                         const FeaturePlanes& features, const Workers& workers) {
  FittedLight sums;
  for (auto& half : sums)
    for (auto& bandwidth : half)
      for (TilePlane& plane : bandwidth) plane.resize(grid.size());
  for_each_tile(grid, workers, true, [&](int x, int y) {
    std::make_unique<TileFits>(grid, light, features, x, y)->add_to(sums);
  });
  return sums;
}

}  // namespace tia
