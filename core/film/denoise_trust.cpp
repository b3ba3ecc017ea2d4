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
// Over which distrust is lone or not: what it comes to on average up to which none of it counts,
// and from which on all of it does. One pixel's is that of the 3 x 3 around: a ninth of 9 x 9.
constexpr int crowd_radius = 4;
constexpr float lone = 0.1F, crowd = 0.3F;
// Of the noise around a pixel over the light there, both squared: from which on halves that agree
// may do so by chance.
constexpr float chance = 0.1F;
// The same, from which on they have no light in common, as it is 1 less what they have: so few have
// found any that they do not tell how noisy it is.
constexpr float nothing_in_common = 0.99F;
// By this share noise may be more than the pixels around say where halves may agree by chance: else
// half of the areas that are as noisy as others would seem to be less so, and keep some noise.
constexpr float more_by_chance = 0.35F;

float square(float v) { return v * v; }

/// Misfit: the squares, over all channels, of what fits are off by and of what noise explains, over
/// the light's around; and what noise there is in the samples' own light around.
struct Misfit {
  TilePlane off, noise, noise_of_own;
};
Misfit misfit_of(const std::array<TilePlane, 3>& fits, const TileGrid& grid,
                 const MeanLight& picture, const TilePlane& inside) {
  const std::size_t size = grid.size();
  Misfit misfit{TilePlane(size), picture.variance, blurred(grid, picture.variance, level_radius)};
  TilePlane own_level(size), fit_level(size);
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < size; ++i) {
      const float albedo = picture.albedo[c][i] * inside[i];
      const float own = picture.light[c][i] * albedo, fit = fits[c][i] * albedo;
      misfit.off[i] += square(fit - own);
      own_level[i] += square(own);
      fit_level[i] += square(fit);
    }
  own_level = blurred(grid, own_level, level_radius);
  fit_level = blurred(grid, fit_level, level_radius);
  for (std::size_t i = 0; i < size; ++i) {
    const float share = 1 / (own_level[i] + fit_level[i] + 1e-30F);
    misfit.off[i] *= share;
    misfit.noise[i] *= share;
    misfit.noise_of_own[i] = own_level[i] > 0 ? misfit.noise_of_own[i] / own_level[i] : 1;
  }
  return misfit;
}

// 1 less the share of the fit that leaves the least squared error.
TilePlane distrust_by(const Misfit& misfit, const TileGrid& grid) {
  TilePlane distrust(grid.size());
  const TilePlane wide = blurred(grid, misfit.noise, tolerances.back().radius);
  for (const Tolerance& each : tolerances) {
    const TilePlane far = blurred(grid, misfit.off, each.radius);
    TilePlane explained = blurred(grid, misfit.noise, each.radius);
    for (std::size_t i = 0; i < far.size(); ++i) {
      const float own = misfit.noise_of_own[i];
      if (own >= nothing_in_common) explained[i] = std::max(explained[i], wide[i]);
      explained[i] *= 1 + more_by_chance * std::clamp(own / chance - 1, 0.0F, 1.0F);
    }
    for (std::size_t i = 0; i < far.size(); ++i)
      if (far[i] > each.variances * explained[i])
        distrust[i] = std::max(distrust[i], 1 - each.variances * explained[i] / far[i]);
  }
  return distrust;
}

// Rare bright samples that both halves happen to have, or not to have where others have them, look
// like detail that is no noise: the halves differ by less than their noise. But such pixels stand
// alone, while fits that are wrong are so over some pixels. Where halves agree on bright light far
// better than such samples would, detail may stand alone.
TilePlane share_that_counts(const TilePlane& distrust, const TilePlane& noise_of_own,
                            const TileGrid& grid, const TilePlane& inside) {
  TilePlane around(grid.size());
  for (std::size_t i = 0; i < around.size(); ++i) around[i] = distrust[i] * inside[i];
  around = blurred(grid, around, crowd_radius);
  const TilePlane pixels = blurred(grid, inside, crowd_radius);
  for (std::size_t i = 0; i < around.size(); ++i) {
    const float mean = around[i] / (pixels[i] + 1e-30F);
    const float crowded = std::clamp((mean - lone) / (crowd - lone), 0.0F, 1.0F);
    const float sure = std::clamp(1 - noise_of_own[i] / chance, 0.0F, 1.0F);
    around[i] = crowded + sure * (1 - crowded);
  }
  return around;
}

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
  const Misfit misfit = misfit_of(fits, grid, picture, inside);
  TilePlane trust = distrust_by(misfit, grid);
  const TilePlane counts = share_that_counts(trust, misfit.noise_of_own, grid, inside);
  for (std::size_t i = 0; i < trust.size(); ++i) trust[i] = 1 - counts[i] * trust[i];
  return trust;
}

}  // namespace tia
