#include "core/film/denoise.h"

#include "core/film/denoise_albedo.h"
#include "core/film/denoise_regression.h"
#include "core/film/denoise_trust.h"

namespace tia {
namespace {

constexpr float own_weight = 0.01F;      // of a pixel's own light, where fits say little of it
constexpr float relative_error = 1e-4F;  // squared: what of light is no error worth the choice
constexpr int error_radius = 4, choice_radius = 2;
// Large, for else bright noise, which varies most, would be given the most weight: a brighter mean.
constexpr int variance_radius_of_light = 3;

/// Denoiser: one picture.
class Denoiser {
 public:
  Denoiser(const HalfBuffers& halves, const Workers& workers)
      : halves_(halves),
        workers_(workers),
        grid_(halves.x0, halves.y0, halves.a.width, halves.a.height) {}

  Image denoised() {
    divide();
    const std::array<TilePlane, 3> fits = fitted();
    const MeanLight picture = mean_light(grid_, halves_, light_);
    const TilePlane trust = trust_in(fits, grid_, picture, light_.inside);
    Image image(grid_.width, grid_.height);
    for (int y = 0; y < grid_.height; ++y)
      for (int x = 0; x < grid_.width; ++x) {
        const std::size_t at = grid_.at(grid_.left + x, grid_.top + y);
        for (std::size_t c = 0; c < 3; ++c) {
          const float own = picture.light[c][at];
          image.at(x, y)[c] = (own + trust[at] * (fits[c][at] - own)) * picture.albedo[c][at];
        }
      }
    return image;
  }

 private:
  // Each half by its own albedo, whose noise is the light's, too.
  void divide() {
    light_.inside = window_of(grid_);
    for (std::size_t h = 0; h < 2; ++h)
      light_.halves[h] =
          over_albedo(grid_, h == 0 ? halves_.a : halves_.b, light_.inside, workers_);
    for (std::size_t c = 0; c < 3; ++c)
      light_.variance[c] =
          half_variance(grid_, light_.halves[0][c], light_.halves[1][c], variance_radius_of_light);
  }

  // Light over albedo as the two bandwidths tell it, each as far as it is chosen.
  std::array<TilePlane, 3> fitted() {
    sums_ = fitted_light(grid_, light_, filtered_features(grid_, halves_, workers_), workers_);
    const TilePlane narrow = choice();
    std::array<TilePlane, 3> fits;
    for (std::size_t c = 0; c < 3; ++c) {
      fits[c].resize(grid_.size());
      for (std::size_t at = 0; at < grid_.size(); ++at) {
        const float wide = both(at, c, 0);
        fits[c][at] = wide + narrow[at] * (both(at, c, 1) - wide);
      }
    }
    sums_ = {};
    return fits;
  }
  float both(std::size_t at, std::size_t c, std::size_t narrow) const {
    return (told(0, narrow, c, at) + told(1, narrow, c, at)) * 0.5F;
  }
  float told(std::size_t h, std::size_t narrow, std::size_t c, std::size_t at) const {
    const auto& sums = sums_[h][narrow];
    return (sums[c][at] + own_weight * light_.halves[h][c][at]) / (sums[3][at] + own_weight);
  }

  // How much larger the squared error of the halves' mean is by the wide bandwidth than by the
  // narrow one. What either half says of the other one differs by its own error and the other's
  // noise, which is the same for both bandwidths; what they say differs by twice the variance that
  // is left, of which the mean has but half.
  float excess(std::size_t at) const {
    float sum = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const float a = light_.halves[0][c][at], b = light_.halves[1][c][at];
      sum += (error(0, c, at) - error(1, c, at)) /
             (light_.variance[c][at] + relative_error * (a * a + b * b) + 1e-30F);
    }
    return sum;
  }
  float error(std::size_t narrow, std::size_t c, std::size_t at) const {
    const float a = told(0, narrow, c, at), b = told(1, narrow, c, at);
    const float of_a = a - light_.halves[1][c][at], of_b = b - light_.halves[0][c][at];
    return of_a * of_a + of_b * of_b - (a - b) * (a - b) * 0.5F;
  }
  // The share of the narrow bandwidth.
  TilePlane choice() const {
    TilePlane narrow(grid_.size());
    for (std::size_t at = 0; at < narrow.size(); ++at) narrow[at] = excess(at) * light_.inside[at];
    narrow = blurred(grid_, narrow, error_radius);
    for (float& each : narrow) each = each > 0 ? 1.0F : 0.0F;
    return blurred(grid_, narrow, choice_radius);
  }

  const HalfBuffers& halves_;
  const Workers& workers_;
  const TileGrid grid_;
  Irradiance light_;
  FittedLight sums_;
};

}  // namespace

Image denoise(const HalfBuffers& halves, const Workers& workers) {
  return Denoiser(halves, workers).denoised();
}

}  // namespace tia
