#include "core/film/denoise_weights.h"

#include <algorithm>

namespace tia {
namespace {

// What numbers may differ by relatively, squared, as if that were noise.
constexpr float relative_rounding = 1e-6F;
constexpr float share_of_patch = 1.0F / ((2 * TileGrid::patch + 1) * (2 * TileGrid::patch + 1));

float positive_mean(float sum) { return std::max(sum * share_of_patch, 0.0F); }

}  // namespace

void PatchDistances::compare_row(std::size_t p, std::size_t q, Row& to) const {
  Row above{}, below;
  below.fill(1e-30F);
  for (std::size_t c = 0; c < static_cast<std::size_t>(guide_.count); ++c) {
    const float *value_p = guide_.value[c] + p, *value_q = guide_.value[c] + q;
    const float *variance_p = guide_.variance[c] + p, *variance_q = guide_.variance[c] + q;
    for (std::size_t i = 0; i < width; ++i) {
      const float u = value_p[i], v = value_q[i], a = variance_p[i], b = variance_q[i];
      const float d = u - v;
      above[i] += d * d - (a + (b < a ? b : a));
      below[i] += (a + b) + (u * u + v * v) * relative_rounding;
    }
  }
  for (std::size_t i = 0; i < width; ++i) to[i] = above[i] / below[i];
}

void PatchDistances::compare(int dx, int dy) {
  for (int y = 0; y < height; ++y) {
    const std::size_t p = grid_.at(x_ - 4, y_ + y - patch);
    const auto q = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(p) + grid_.step(dx, dy));
    compare_row(p, q, rows_[static_cast<std::size_t>(y)]);
  }
}

PatchDistances::Row PatchDistances::column_sums(int y) const {
  const Row* rows = &rows_[static_cast<std::size_t>(y)];
  Row sums = rows[0];
  for (std::size_t k = 1; k <= 2 * patch; ++k)
    for (std::size_t i = 0; i < width; ++i) sums[i] += rows[k][i];
  return sums;
}

void PatchDistances::of_all(int dx, int dy, std::array<std::array<float, tile>, tile>& distances) {
  compare(dx, dy);
  for (int y = 0; y < tile; ++y) {
    const Row sums = column_sums(y);
    std::array<float, tile>& to = distances[static_cast<std::size_t>(y)];
    for (std::size_t i = 0; i < tile; ++i) to[i] = sums[i + 1];
    for (std::size_t k = 1; k <= 2 * patch; ++k)
      for (std::size_t i = 0; i < tile; ++i) to[i] += sums[i + 1 + k];
    for (float& each : to) each = positive_mean(each);
  }
}

void PatchDistances::of_centers(int dx, int dy,
                                std::array<std::array<float, centers>, centers>& distances) {
  compare(dx, dy);
  std::array<float, width / 2> even, odd;
  for (int y = 0; y < centers; ++y) {
    const Row sums = column_sums(2 * y);
    for (std::size_t i = 0; i < width / 2; ++i) even[i] = sums[2 * i], odd[i] = sums[2 * i + 1];
    std::array<float, centers>& to = distances[static_cast<std::size_t>(y)];
    for (std::size_t i = 0; i < centers; ++i)
      to[i] = positive_mean(odd[i] + odd[i + 1] + odd[i + 2] + odd[i + 3] +
                            (even[i + 1] + even[i + 2] + even[i + 3]));
  }
}

}  // namespace tia
