#include "core/lights/sky_map.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/math/onb.h"

namespace tia {
namespace {

constexpr int most_columns = 1024;  // of cells

// The share of the direction's light that eyes see, of linear sRGB. Source: IEC 61966-2-1.
double luminance(const Vec3f& c) {
  return 0.2126 * double{c.x} + 0.7152 * double{c.y} + 0.0722 * double{c.z};
}

// Makes sums of weights, each that of those before it, shares of their sum. Returns: the sum.
double make_shares(std::span<double> sums) {
  double sum = 0;
  for (double& each : sums) sum += std::exchange(each, sum);
  if (sum > 0)
    for (double& each : sums) each /= sum;
  return sum;
}

// Which of the parts between increasing edges from 0 to 1 a number falls into: none that is empty.
std::size_t part_of(std::span<const double> edges, double u) {
  const auto above = std::upper_bound(edges.begin(), edges.end(), u);
  const auto at =
      above == edges.end() ? std::lower_bound(edges.begin(), edges.end(), edges.back()) : above;
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(at - edges.begin(), 1)) - 1;
}

Vec3f between(const Vec3f& a, const Vec3f& b, float share) { return a + (b - a) * share; }

}  // namespace

Vec3d sky_direction(double azimuth_turn, double cosine) {
  const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
  const auto [east, north] = sincos_of(2 * pi * azimuth_turn);
  return {sine * east, cosine, -sine * north};
}

SkyMap::SkyMap(int width, int height, Texels texels)
    : width_(width),
      height_(height),
      block_((width + most_columns - 1) / most_columns),
      texels_(std::move(texels)),
      columns_(static_cast<std::size_t>((width + block_ - 1) / block_)),
      rows_(static_cast<std::size_t>((height + block_ - 1) / block_)),
      below_(rows_ * (columns_ + 1)),
      rows_sum_(rows_ + 1),
      cosines_(rows_ + 1) {
  for (std::size_t row = 0; row <= rows_; ++row) cosines_[row] = cos_of(pi * upper_edge(row));
  cosines_.back() = -1;
  weigh();
}

double SkyMap::left_edge(std::size_t column) const {
  return std::min(1.0, static_cast<double>(column) * block_ / width_);
}
double SkyMap::upper_edge(std::size_t row) const {
  return std::min(1.0, static_cast<double>(row) * block_ / height_);
}

// The mean of what is seen of a texel's square is 6/8 of its own light and 1/8 of either
// neighbour's along each axis: the hat functions' integrals.
void SkyMap::weigh() {
  const auto columns = static_cast<std::size_t>(width_);
  std::vector<double> up(columns), own(columns), down(columns), mean(columns);
  const auto read = [&](int y, std::vector<double>& row) {
    y = std::clamp(y, 0, height_ - 1);
    for (int x = 0; x < width_; ++x) row[static_cast<std::size_t>(x)] = luminance(texel(x, y));
  };
  read(0, up), read(0, own), read(1, down);
  for (int y = 0; y < height_; ++y) {
    for (std::size_t x = 0; x < columns; ++x) mean[x] = (up[x] + 6 * own[x] + down[x]) / 8;
    const auto row = static_cast<std::size_t>(y / block_);
    for (std::size_t x = 0; x < columns; ++x) {
      const double left = mean[x > 0 ? x - 1 : columns - 1];
      const double right = mean[x + 1 < columns ? x + 1 : 0];
      below_[row * (columns_ + 1) + x / static_cast<std::size_t>(block_)] +=
          (left + 6 * mean[x] + right) / 8;
    }
    up.swap(own), own.swap(down);
    read(y + 2, down);
  }
  for (std::size_t row = 0; row < rows_; ++row) {
    const double sum = make_shares(std::span(below_).subspan(row * (columns_ + 1), columns_ + 1));
    const double texels = static_cast<double>(
        std::min(height_, static_cast<int>(row + 1) * block_) - static_cast<int>(row) * block_);
    rows_sum_[row] = sum / texels * (cosines_[row] - cosines_[row + 1]);
  }
  make_shares(rows_sum_);
}

Vec3f SkyMap::texel(int x, int y) const {
  if (const auto* picture = std::get_if<0>(&texels_)) return (*picture)->texel(x, y);
  return std::get<1>(texels_)[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                              static_cast<std::size_t>(x)];
}

SkyMap::Place SkyMap::place_of(const Vec3d& wi, double turn) {
  const double azimuth = turn_of(wi.x, -wi.z) - turn + 0.5;
  const double x = azimuth - std::floor(azimuth);
  const double y = atan2_of(std::sqrt(wi.x * wi.x + wi.z * wi.z), wi.y) / pi;
  return {x < 1 ? x : 0, std::min(y, 1.0)};
}

Vec3f SkyMap::radiance(const Vec3d& wi, double turn) const {
  const Place at = place_of(wi, turn);
  const double x = at.x * width_ - 0.5, y = at.y * height_ - 0.5;
  const double left = std::floor(x), upper = std::floor(y);
  const int i = static_cast<int>(left), j = static_cast<int>(upper);
  const auto row = [&](int k) {
    const int inside = std::clamp(k, 0, height_ - 1);
    return between(texel(i < 0 ? width_ - 1 : i, inside), texel(i + 1 < width_ ? i + 1 : 0, inside),
                   static_cast<float>(x - left));
  };
  return between(row(j), row(j + 1), static_cast<float>(y - upper));
}

double SkyMap::density(std::size_t column, std::size_t row) const {
  const double* shares = &below_[row * (columns_ + 1)];
  const double share =
      (rows_sum_[row + 1] - rows_sum_[row]) * (shares[column + 1] - shares[column]);
  const double around = 2 * pi * (left_edge(column + 1) - left_edge(column));
  return share / (around * (cosines_[row] - cosines_[row + 1]));
}

SkyMap::Sample SkyMap::sample(double u, double v, double turn) const {
  if (!(rows_sum_.back() > 0)) return {{0, 1, 0}, 0};
  const std::size_t row = part_of(rows_sum_, v);
  const std::span shares = std::span(below_).subspan(row * (columns_ + 1), columns_ + 1);
  const std::size_t column = part_of(shares, u);
  const double down = (v - rows_sum_[row]) / (rows_sum_[row + 1] - rows_sum_[row]);
  const double aside = (u - shares[column]) / (shares[column + 1] - shares[column]);
  const double left = left_edge(column), right = left_edge(column + 1);
  const double cosine = cosines_[row] + down * (cosines_[row + 1] - cosines_[row]);
  return {sky_direction(left + aside * (right - left) - 0.5 + turn, cosine), density(column, row)};
}

double SkyMap::pdf(const Vec3d& wi, double turn) const {
  if (!(rows_sum_.back() > 0)) return 0;
  const Place at = place_of(wi, turn);
  const auto cell = [&](double place, int texels, std::size_t cells) {
    return std::min(static_cast<std::size_t>(place * texels / block_), cells - 1);
  };
  return density(cell(at.x, width_, columns_), cell(at.y, height_, rows_));
}

std::size_t SkyMap::bytes() const {
  const auto* picture = std::get_if<0>(&texels_);
  return sizeof *this + heap_bytes(below_) + heap_bytes(rows_sum_) + heap_bytes(cosines_) +
         (picture != nullptr ? heap_bytes(**picture) : heap_bytes(std::get<1>(texels_)));
}

}  // namespace tia
