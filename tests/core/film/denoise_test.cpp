// The denoiser and the filter of previews, as functions of half buffers that are made here.
#include "core/film/denoise.h"

#include <gtest/gtest.h>

#include "core/film/denoise_albedo.h"
#include "core/film/denoise_regression.h"
#include "core/film/preview_filter.h"
#include "core/parallel/pool.h"
#include "tests/core/film/half_buffers.h"
#include "tests/sanitizer.h"

namespace tia {
namespace {

using test::blank;
using test::Chance;
using test::Field;
using test::fill;
using test::fill_light;
using test::height;
using test::mean_of;
using test::mean_square;
using test::noisy;
using test::Plane;
using test::width;

// ---- laws ---------------------------------------------------------------------------------------

TEST(Denoise, LeavesALightThatIsTheSameEverywhere) {
  Chance chance;
  HalfBuffers halves = blank();
  fill_light(halves, [](double, double) { return 0.7; });
  for (int plane = Plane::normal; plane < Plane::count; ++plane)
    for (PixelPlanes* half : {&halves.a, &halves.b})
      fill(*half, plane, [&](double, double) { return chance.unit(); });
  for (const Image& image : {denoise(halves), preview(halves.a)})
    for (const float each : image.rgb) EXPECT_NEAR(each, 0.7F, 0.7e-6F);
}

// Every pixel has a light of its own, by 0.3 more or less, which no feature tells: the picture is
// not made notably worse, be noise none, less than that, or as much.
TEST(Denoise, LeavesDetailThatIsNoNoise) {
  for (const double noise : test::cases({0.0, 0.1, 0.2, 0.3})) {
    Chance chance;
    HalfBuffers halves = blank();
    std::vector<double> lights(halves.a.size());
    for (double& each : lights) each = 0.2 + chance.unit();
    const Field truth = [&](double x, double y) {
      return lights[static_cast<std::size_t>(y * width + x)];
    };
    for (PixelPlanes* half : {&halves.a, &halves.b})
      for (int c = 0; c < 3; ++c)
        fill(*half, c, [&](double x, double y) { return truth(x, y) + noise * chance.normal(); });
    const double before = mean_square(noisy(halves), truth);
    EXPECT_LE(mean_square(denoise(halves), truth), 1.1 * before + 1e-12) << noise;
  }
}

// Light of 1 everywhere that one sample in twenty finds. Where both halves have found it, or
// neither has around, they agree, and yet that is noise.
TEST(Denoise, TakesOffBrightSamplesThatHalvesShareByChance) {
  constexpr double share = 0.05;
  const Field truth = [](double, double) { return 1; };
  for (const int of_half : test::cases({2, 8})) {
    Chance chance;
    HalfBuffers halves = blank();
    for (PixelPlanes* half : {&halves.a, &halves.b}) {
      fill(*half, Plane::light, [&](double, double) {
        int found = 0;
        for (int i = 0; i < of_half; ++i) found += chance.unit() < share ? 1 : 0;
        return found / (of_half * share);
      });
      half->planes[1] = half->planes[2] = half->planes[0];
    }
    const Image before = noisy(halves), image = denoise(halves);
    const double cut = of_half == 2 ? 45 : 50, of_mean = of_half == 2 ? 0.02 : 0.01;
    EXPECT_LT(mean_square(image, truth) * cut, mean_square(before, truth)) << of_half;
    EXPECT_NEAR(mean_of(image), mean_of(before), of_mean) << of_half;
  }
}

// What fits say of a channel of one half where noise is so large that all pixels count, before
// anything asks how far they are to be trusted.
Image fits_of(const HalfBuffers& halves, std::size_t narrow, std::size_t channel) {
  const TileGrid grid(0, 0, halves.a.width, halves.a.height);
  Irradiance light;
  light.inside = window_of(grid);
  for (std::size_t h = 0; h < 2; ++h)
    light.halves[h] = over_albedo(grid, h == 0 ? halves.a : halves.b, light.inside, {});
  for (TilePlane& variance : light.variance) variance.assign(grid.size(), 1);
  const FittedLight sums = fitted_light(grid, light, filtered_features(grid, halves, {}), {});
  Image image(grid.width, grid.height);
  for (int y = 0; y < grid.height; ++y)
    for (int x = 0; x < grid.width; ++x) {
      const std::size_t at = grid.at(x, y);
      image.at(x, y)[channel] = sums[0][narrow][channel][at] / sums[0][narrow][3][at];
    }
  return image;
}

// Two of the features vary, and light with one of them.
TEST(Denoise, GivesBackLightThatIsLinearInAFeature) {
  for (const int plane : {3, 6, 7, 8, 9, 10}) {
    if (test::sanitized() && plane % 4 != 3) continue;  // one of albedo and one of normals
    const Field feature = [](double x, double y) {
      return 0.5 + 0.2 * std::sin(x * 0.21) + 0.15 * std::cos(y * 0.3 + x * 0.05);
    };
    HalfBuffers halves = blank();
    fill(halves, plane, feature);
    if (plane < Plane::normal)  // which light is divided by, so that it is linear in what is left
      for (const int other : {4, 5}) fill(halves, other, feature);
    fill(halves, plane == Plane::visibility ? int{Plane::depth} : int{Plane::visibility},
         [](double x, double y) { return 0.5 + 0.3 * std::sin(x * 0.11 + y * 0.2); });
    const Field light = [&](double x, double y) {
      const double f = feature(x, y);
      return (0.3 + 1.5 * f) * (plane < Plane::normal ? f : 1);
    };
    fill_light(halves, light);
    const Image image = denoise(halves), wide = fits_of(halves, 0, 1),
                narrow = fits_of(halves, 1, 1);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const double is = light(x, y), fit = is / (plane < Plane::normal ? feature(x, y) : 1);
        EXPECT_NEAR(image.at(x, y)[1], is, 1e-5 * is) << plane << ' ' << x;
        EXPECT_NEAR(wide.at(x, y)[1], fit, 1e-5 * fit) << plane << ' ' << x;
        EXPECT_NEAR(narrow.at(x, y)[1], fit, 1e-5 * fit) << plane << ' ' << x;
      }
  }
}

// The irradiance at (x, y, 0) under a square light of radiance 1 that faces down from height h.
// Source: Lambert, "Photometria" (1760), as in pbrt: half the sum over its edges of the angle that
// the edge subtends times the cosine of its plane's normal.
double under_square(double x, double y, double h, double side) {
  const double corner[5][2] = {{-1, -1}, {-1, 1}, {1, 1}, {1, -1}, {-1, -1}};
  double sum = 0;
  for (int i = 0; i < 4; ++i) {
    const double ax = corner[i][0] * side / 2 - x, ay = corner[i][1] * side / 2 - y;
    const double bx = corner[i + 1][0] * side / 2 - x, by = corner[i + 1][1] * side / 2 - y;
    const double nx = ay * h - h * by, ny = h * bx - ax * h, nz = ax * by - ay * bx;
    const double n = std::sqrt(nx * nx + ny * ny + nz * nz);
    sum += std::atan2(n, ax * bx + ay * by + h * h) * nz / n;
  }
  return std::fabs(sum) / 2;
}
// The same estimated by points drawn evenly on the light.
double estimated(double x, double y, double h, double side, int samples, Chance& chance) {
  double sum = 0;
  for (int i = 0; i < samples; ++i) {
    const double dx = (chance.unit() - 0.5) * side - x, dy = (chance.unit() - 0.5) * side - y;
    const double square = dx * dx + dy * dy + h * h;
    sum += h * h / (square * square) * side * side;
  }
  return sum / samples;
}

TEST(Denoise, CutsTheErrorUnderASquareLight) {
  constexpr double h = 0.6, side = 1;
  const auto place = [](double pixel, int size) { return (pixel + 0.5) / size * 3 - 1.5; };
  const Field truth = [&](double x, double y) {
    return under_square(place(x, width), place(y, height), h, side);
  };
  for (const int samples : test::cases({4, 16})) {
    const double cut = samples == 4 ? 4 : 3;
    Chance chance;
    HalfBuffers halves = blank();
    for (PixelPlanes* half : {&halves.a, &halves.b})
      for (int c = 0; c < 3; ++c)
        fill(*half, c, [&](double x, double y) {
          return estimated(place(x, width), place(y, height), h, side, samples / 2, chance);
        });
    const Image before = noisy(halves), image = denoise(halves);
    EXPECT_LT(mean_square(image, truth) * cut, mean_square(before, truth)) << samples;
    EXPECT_NEAR(mean_of(image), mean_of(before), 0.005 * mean_of(before)) << samples;
  }
}

// Between the columns beside the middle, at least 95 % of what it is.
void contrast_of_edge(const Image& image, double is) {
  double left = 0, right = 0;
  for (int y = 0; y < height; ++y)
    left += static_cast<double>(image.at(34, y)[0]),
        right += static_cast<double>(image.at(35, y)[0]);
  EXPECT_GT((right - left) / height, 0.95 * is);
  EXPECT_LT((right - left) / height, 1.05 * is);
}

// Light of noise 0.1 on both sides of an edge in the middle, which a feature tells.
TEST(Denoise, KeepsEdgesThatFeaturesTell) {
  const auto step = [](double low, double high) {
    return [=](double x, double) { return x < 35 ? low : high; };
  };
  for (const int plane : test::cases({3, 6, 10}, 2)) {
    Chance chance;
    HalfBuffers halves = blank();
    SCOPED_TRACE(plane);
    for (int c = 0; c < (plane == Plane::albedo ? 3 : 1); ++c)
      fill(halves, plane + c, step(0.3, 0.9));
    const Field truth = step(0.3, 0.9);
    for (PixelPlanes* half : {&halves.a, &halves.b})
      for (int c = 0; c < 3; ++c)
        fill(*half, c,
             [&](double x, double y) { return truth(x, y) * (1 + 0.1 * chance.normal()); });
    contrast_of_edge(denoise(halves), 0.6);
    if (plane != Plane::visibility) contrast_of_edge(preview(halves.a), 0.6);
  }
}

/// A picture that has something of all, noise in features too.
HalfBuffers eventful(int w, int h, int x0 = 0, int y0 = 0) {
  HalfBuffers halves = blank(w, h);
  halves.x0 = x0, halves.y0 = y0;
  std::size_t number = 0;
  for (PixelPlanes* half : {&halves.a, &halves.b}) {
    ++number;
    for (int plane = 0; plane < Plane::count; ++plane)
      fill(*half, plane, [&](double column, double row) {
        const double x = column + x0, y = row + y0;
        std::mt19937 bits(static_cast<unsigned>(((y * 997 + x) * 31 + plane) * 2 + double(number)));
        const double noise = static_cast<double>(bits()) / 4294967296.0 - 0.5;
        if (plane == Plane::normal) return 0.2;  // without noise
        if (plane < Plane::albedo && noise > 0.48) return 60.0;
        return 1 + 0.4 * std::sin(x * 0.2 + plane) + (x + y > 90 ? 0.5 : 0) + 0.3 * noise;
      });
  }
  return halves;
}

TEST(Denoise, OfAWindowWithItsMarginIsTheWholesWindow) {
  constexpr int w = 100, h = 94, x0 = 41, y0 = 37, x1 = w - 8, y1 = h - 8;
  const Image all = denoise(eventful(w, h));
  const int left = x0 - denoise_margin, top = y0 - denoise_margin;
  const Image part = denoise(eventful(x1 - left, y1 - top, left, top));
  for (int y = y0; y < y1 - denoise_margin; ++y)
    for (int x = x0; x < x1 - denoise_margin; ++x)
      for (int c = 0; c < 3; ++c)
        ASSERT_EQ(part.at(x - left, y - top)[c], all.at(x, y)[c]) << x << ' ' << y;
}

TEST(Denoise, GivesTheSameBytesToAnyThreads) {
  const HalfBuffers halves = eventful(test::sanitized() ? 40 : 100, 70, 5, 3);
  const Image denoised = denoise(halves), previewed = preview(halves.a);
  Pool pool(3);
  EXPECT_EQ(denoise(halves, pool.workers(3)).rgb, denoised.rgb);
  EXPECT_EQ(preview(halves.a, pool.workers(3)).rgb, previewed.rgb);
}

TEST(Denoise, LightWithoutBoundStaysAlone) {
  HalfBuffers halves = blank();
  halves.a.planes[1][20 * width + 30] = std::numeric_limits<float>::infinity();
  halves.b.planes[1][20 * width + 30] = std::numeric_limits<float>::quiet_NaN();
  const Image denoised = denoise(halves), previewed = preview(halves.a);
  const std::size_t hole = 3 * (20 * width + 30) + 1;
  for (std::size_t i = 0; i < denoised.rgb.size(); ++i) {
    EXPECT_NEAR(denoised.rgb[i], i == hole ? 0 : 1, 1e-6);
    EXPECT_NEAR(previewed.rgb[i], 1, 1e-6);  // from around
  }
}

TEST(Preview, CutsTheErrorOfASample) {
  Chance chance;
  HalfBuffers halves = blank();
  for (int c = 0; c < 3; ++c) fill(halves.a, c, [&](double, double) { return 2 * chance.unit(); });
  const Field truth = [](double, double) { return 1; };
  EXPECT_LT(mean_square(preview(halves.a), truth) * 10, 1.0 / 3);
}

}  // namespace
}  // namespace tia
