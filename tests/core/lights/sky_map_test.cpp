// Directions drawn from skies, against their densities.
#include "core/lights/sky_map.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/support.h"

namespace tia {
namespace {

using test::Random;
using test::rounds;

// Few bright texels among dark and black ones.
std::vector<Vec3f> random_texels(int width, Random& random) {
  std::vector<Vec3f> texels(static_cast<std::size_t>(width * width / 2));
  for (Vec3f& texel : texels) {
    const double light = random.chance(0.3) ? 0 : std::pow(random.unit(), 8.0) * 100;
    texel = static_cast<Vec3f>(Vec3d{light, light * random.unit(), light});
  }
  texels[0] = {1, 1, 1};
  return texels;
}
SkyMap random_map(Random& random) {
  const int width = 2 * random.whole(1, 12);
  return SkyMap(width, width / 2, random_texels(width, random));
}

// Each of the cells of equal solid angle gets as many samples as the density's integral says: by
// chi-squared, whose mean is the number of cells less 1.
TEST(SkyMap, SamplesFallAsDenseAsTheDensitySays) {
  Random random(910);
  constexpr int around = 8, down = 8, count = 4096;
  for (int i = 0; i < rounds(100, 5); ++i) {
    const SkyMap map = random_map(random);
    const double turn = random.in(-1, 1);
    std::array<double, around * down> expected{}, got{};
    const auto cell = [&](const Vec3d& wi) {
      const double azimuth = std::atan2(wi.x, wi.z) / (2 * pi) + 0.5;
      const int x = std::min(static_cast<int>(azimuth * around), around - 1);
      const int y = std::min(static_cast<int>((wi.y + 1) / 2 * down), down - 1);
      return static_cast<std::size_t>(y * around + x);
    };
    // As many directions evenly over the sphere as make the integral good to a few percent.
    constexpr int fine = 24;
    for (int y = 0; y < fine * down; ++y)
      for (int x = 0; x < fine * around; ++x) {
        const double azimuth = 2 * pi * (x + random.unit()) / (fine * around) - pi;
        const double height = 2 * (y + random.unit()) / (fine * down) - 1;
        const double aside = std::sqrt(1 - height * height);
        const Vec3d wi{aside * std::sin(azimuth), height, aside * std::cos(azimuth)};
        expected[cell(wi)] += map.pdf(wi, turn) * 4 * pi / (fine * fine * around * down) * count;
      }
    for (int k = 0; k < count; ++k) {
      const double u = random.unit();
      const SkyMap::Sample sample = map.sample(u, random.unit(), turn);
      EXPECT_NEAR(length(sample.wi), 1, 1e-12);
      ASSERT_NEAR(sample.pdf, map.pdf(sample.wi, turn), 1e-6 * sample.pdf);
      ++got[cell(sample.wi)];
    }
    double statistic = 0, sum = 0;
    int cells = 0;
    for (std::size_t k = 0; k < expected.size(); ++k) {
      sum += expected[k];
      if (expected[k] < 5) continue;
      statistic += (got[k] - expected[k]) * (got[k] - expected[k]) / expected[k];
      ++cells;
    }
    EXPECT_NEAR(sum, count, 0.01 * count) << "integrates to 1";
    EXPECT_LT(statistic, cells + 6 * std::sqrt(2.0 * cells) + 5) << map.width();
  }
}

// Whatever is seen can be drawn: light by its samples is the integral of what is seen.
TEST(SkyMap, SamplesFindAllThatIsSeen) {
  Random random(911);
  for (int i = 0; i < rounds(6, 2); ++i) {
    const SkyMap map = random_map(random);
    const double turn = random.unit();
    const Vec3d axis = random.direction();
    double by_light = 0, squares = 0, evenly = 0, even_squares = 0;
    constexpr int count = 40'000;
    const auto seen = [&](const Vec3d& wi) {
      return double{map.radiance(wi, turn).x} * (1 + dot(wi, axis));
    };
    for (int k = 0; k < count; ++k) {
      const double u = random.unit();
      const auto sample = map.sample(u, random.unit(), turn);
      const double one = seen(sample.wi) / sample.pdf;
      by_light += one / count, squares += one * one / count;
      const double other = seen(random.direction()) * 4 * pi;
      evenly += other / count, even_squares += other * other / count;
    }
    const double error = std::sqrt((squares - by_light * by_light) / count +
                                   (even_squares - evenly * evenly) / count);
    EXPECT_NEAR(by_light, evenly, 4 * error);
  }
}

TEST(SkyMap, TexelsStandWhereTheyBelong) {
  std::vector<Vec3f> texels(32);
  texels[1 * 8 + 4] = {8, 0, 0};  // below the middle of row 1: right of the north
  const SkyMap map(8, 4, texels);
  const double height = std::cos(1.5 * pi / 4);
  // The column's centre is half a column right of the middle: in the north-east.
  EXPECT_NEAR(double{map.radiance(sky_direction(0.5 / 8, height), 0).x}, 8, 1e-5);
  EXPECT_NEAR(double{map.radiance(sky_direction(0.5 / 8 + 0.25, height), 0.25).x}, 8, 1e-5);
  EXPECT_NEAR(double{map.radiance(sky_direction(0, height), 0).x}, 4, 1e-5) << "between two";
  const Vec3d east = sky_direction(0.25, 0), north = sky_direction(0, 0);
  EXPECT_NEAR(east.x, 1, 1e-12);
  EXPECT_NEAR(north.z, -1, 1e-12);
}

TEST(SkyMap, BlackGivesNothing) {
  const SkyMap map(4, 2, std::vector<Vec3f>(8));
  EXPECT_EQ(map.sample(0.3, 0.4, 0).pdf, 0);
  EXPECT_EQ(map.pdf({0, 1, 0}, 0), 0);
}

// Beyond 1024 columns several texels are one cell.
TEST(SkyMap, LargePicturesAreDrawnByBlocks) {
  Random random(912);
  const SkyMap map(2050, 1025, [&] {
    std::vector<Vec3f> texels(std::size_t{2050} * 1025);
    for (int i = 0; i < 9; ++i)
      texels[static_cast<std::size_t>(random.below(2050 * 1025))] = {1, 1, 1};
    texels.back() = {1, 1, 1};
    return texels;
  }());
  for (int i = 0; i < 2000; ++i) {
    const double u = random.unit();
    const auto sample = map.sample(u, random.unit(), 0.2);
    ASSERT_NEAR(sample.pdf, map.pdf(sample.wi, 0.2), 1e-6 * sample.pdf);
  }
}

}  // namespace
}  // namespace tia
