#include "core/render/preview_light.h"

#include <cmath>

#include "core/film/preview_filter.h"

namespace tia {
namespace {

double square(double v) { return v * v; }

// Whether what rays have found of two pixels is hardly different.
bool are_of_one_surface(const PixelPlanes& pixels, std::size_t i, std::size_t j) {
  double off = 0;
  for (std::size_t k = PixelPlanes::albedo; k < PixelPlanes::count; ++k) {
    const auto a = static_cast<double>(pixels.planes[k][i]);
    const auto b = static_cast<double>(pixels.planes[k][j]);
    off += square(a - b) / (k == PixelPlanes::depth ? a * a + b * b + 1e-15 : 1);
  }
  return off < 0.01;
}

}  // namespace

PreviewLight::PreviewLight(int width, int height, int side)
    : side_(side), planes_((width + side - 1) / side, (height + side - 1) / side) {}

void PreviewLight::put(const FilmTile& place, const TilePixels& pixels) {
  for (int y = 0; y < pixels.height; y += side_)
    for (int x = 0; x < pixels.width; x += side_) {
      const auto from =
          static_cast<std::size_t>(middle_of_block(pixels, side_, y * pixels.width + x));
      const int column = (place.x + x) / side_, row = (place.y + y) / side_;
      const auto to = static_cast<std::size_t>(row * planes_.width + column);
      const Estimate& estimate = pixels.estimates[from];
      const Vec3f light = estimate.mean();
      planes_.planes[0][to] = light.x;
      planes_.planes[1][to] = light.y;
      planes_.planes[2][to] = light.z;
      for (std::size_t k = 0; k < Guides::numbers; ++k)
        planes_.planes[PixelPlanes::albedo + k][to] =
            static_cast<float>(pixels.guided[from].found[k] / estimate.count);
    }
}

const Image& PreviewLight::filter(const Workers& workers) {
  image_ = preview(planes_, workers);
  if (has_come_nearer(image_)) return image_;
  for (std::size_t i = 0; i < planes_.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) image_.rgb[3 * i + c] = planes_.planes[c][i];
  return image_;
}

// What a filter changes is the noise that it takes off and what it does wrong: it does less wrong
// than the noise was while its changes, squared, are less than twice the noise. That is told by
// pixels side by side of the same surface, as half the square of what they differ by. Light of more
// than four times the mean counts as that, for else a few bright pixels would decide.
bool PreviewLight::has_come_nearer(const Image& filtered) const {
  double all = 0;
  for (const int c : {0, 1, 2})
    for (const float each : planes_.planes[static_cast<std::size_t>(c)])
      if (std::isfinite(each)) all += static_cast<double>(each);
  const double most = 4 * all / (3 * static_cast<double>(planes_.size()));
  const auto seen = [most](float light) {
    return std::isfinite(light) ? std::min(static_cast<double>(light), most) : 0;
  };
  double change = 0, noise = 0, pairs = 0;
  for (std::size_t i = 0; i + 1 < planes_.size(); ++i) {
    const bool is_pair = (i + 1) % static_cast<std::size_t>(planes_.width) != 0 &&
                         are_of_one_surface(planes_, i, i + 1);
    pairs += is_pair ? 1 : 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const double here = seen(planes_.planes[c][i]);
      change += square(here - seen(filtered.rgb[3 * i + c]));
      if (is_pair) noise += square(here - seen(planes_.planes[c][i + 1])) / 2;
    }
  }
  return pairs > 0 && change < 2 * noise / pairs * static_cast<double>(planes_.size());
}

void PreviewLight::light(FilmTile& tile) const {
  for (int y = 0; y < tile.height; ++y)
    for (int x = 0; x < tile.width; ++x) {
      const float* const light = image_.at((tile.x + x) / side_, (tile.y + y) / side_);
      const std::size_t at = FilmTile::index(x, y);
      tile.r[at] = light[0], tile.g[at] = light[1], tile.b[at] = light[2];
    }
}

}  // namespace tia
