#include "core/film/denoise_trust.h"

#include <algorithm>

#include "core/film/denoise_albedo.h"

namespace tia {
namespace {

constexpr int level_radius = 1;  // over which light is about as bright
// Around a pixel so far the fit may be off by so many variances: the noise of few pixels may
// seem less than it is.
struct Tolerance {
  int radius;
  float variances;
};
constexpr std::array tolerances{Tolerance{1, 2.0F}, Tolerance{4, 1.0F}};

float square(float v) { return v * v; }

}  // namespace

MeanLight mean_light(const TileGrid& grid, const HalfBuffers& halves, const Irradiance& light) {
  MeanLight mean;
  mean.variance.resize(grid.size());
  for (std::size_t c = 0; c < 3; ++c) {
    const TilePlane a = padded(grid, halves.a.planes[PixelPlanes::albedo + c]);
    const TilePlane b = padded(grid, halves.b.planes[PixelPlanes::albedo + c]);
    mean.light[c].resize(grid.size());
    mean.albedo[c].resize(grid.size());
    for (std::size_t i = 0; i < grid.size(); ++i) {
      const float of_a = light.halves[0][c][i], of_b = light.halves[1][c][i];
      const float albedo = divisor_of((a[i] + b[i]) * 0.5F);
      mean.albedo[c][i] = albedo;
      mean.light[c][i] = (of_a * divisor_of(a[i]) + of_b * divisor_of(b[i])) * 0.5F / albedo;
      mean.variance[i] += square((of_a - of_b) * albedo) * 0.25F;
    }
  }
  for (std::size_t i = 0; i < grid.size(); ++i) mean.variance[i] *= light.inside[i];
  return mean;
}

TilePlane trust_in(const std::array<TilePlane, 3>& fits, const TileGrid& grid,
                   const MeanLight& picture, const TilePlane& inside) {
  TilePlane off(grid.size()), noise = picture.variance, level(grid.size());
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < off.size(); ++i) {
      const float albedo = picture.albedo[c][i] * inside[i];
      const float own = picture.light[c][i] * albedo, fit = fits[c][i] * albedo;
      off[i] += square(fit - own);
      level[i] += square(fit) + square(own);
    }
  level = blurred(grid, level, level_radius);
  for (std::size_t i = 0; i < off.size(); ++i) {
    const float share = 1 / (level[i] + 1e-30F);
    off[i] *= share;
    noise[i] *= share;
  }
  TilePlane trust(grid.size(), 1.0F);
  for (const Tolerance& each : tolerances) {
    const TilePlane far = blurred(grid, off, each.radius);
    const TilePlane explained = blurred(grid, noise, each.radius);
    for (std::size_t i = 0; i < off.size(); ++i)
      if (far[i] > each.variances * explained[i])
        trust[i] = std::min(trust[i], each.variances * explained[i] / far[i]);
  }
  return trust;
}

}  // namespace tia
