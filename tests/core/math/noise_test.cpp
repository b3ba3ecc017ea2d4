#include "core/math/noise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tests/core/support.h"

namespace tia {
namespace {

using test::Random;

// What K. Perlin's implementation (mrl.nyu.edu/~perlin/noise) is known to give at these points.
TEST(GradientNoise, GivesThePublishedNumbers) {
  EXPECT_EQ(gradient_noise({3.14, 42, 7}), 0.13691995878400012);
  EXPECT_EQ(gradient_noise({-4.20, 10, 6}), 0.14208000000000043);
}

TEST(GradientNoise, IsZeroAtIntegers) {
  Random random(300);
  for (int i = 0; i < 1000; ++i) {
    const Vec3d p = random.point(1000);
    EXPECT_EQ(gradient_noise({std::floor(p.x), std::floor(p.y), std::floor(p.z)}), 0);
  }
}

// In the middle of a cell all eight corners weigh the same: the mean of their slopes, each of which
// is the sum of two of -0.5 and 0.5.
TEST(GradientNoise, IsAnEighthOfAnIntegerInTheMiddleOfCells) {
  bool not_zero = false;
  for (int i = 0; i < 500; ++i) {
    const double eighths = 8 * gradient_noise({i + 0.5, 0.5 - i % 7, i % 3 + 0.5});
    EXPECT_EQ(eighths, std::floor(eighths));
    not_zero = not_zero || eighths != 0;
  }
  EXPECT_TRUE(not_zero);
}

TEST(GradientNoise, StaysInRangeAndUsesIt) {
  Random random(301);
  double least = 0, most = 0, sum = 0;
  constexpr int count = 200'000;
  for (int i = 0; i < count; ++i) {
    const double noise = gradient_noise(random.point(300));
    least = std::min(least, noise);
    most = std::max(most, noise);
    sum += noise;
  }
  EXPECT_GE(least, -1.037);
  EXPECT_LE(most, 1.037);
  EXPECT_LT(least, -0.8);
  EXPECT_GT(most, 0.8);
  EXPECT_NEAR(sum / count, 0, 0.01);
}

TEST(GradientNoise, HasNoSteps) {
  Random random(302);
  constexpr double step = 1e-6;
  for (int i = 0; i < 20'000; ++i) {
    Vec3d p = random.point(20);
    if (i % 2 == 0) p.x = std::floor(p.x) - step / 2;  // across the border of two cells
    const Vec3d way = random.direction();
    EXPECT_NEAR(gradient_noise(p + way * step), gradient_noise(p), 5 * step);
  }
}

TEST(GradientNoise, RepeatsAfter256) {
  Random random(303);
  for (int i = 0; i < 1000; ++i) {
    const Vec3d point = random.point(100);
    const auto exact = [](double x) { return std::floor(x * 1024) / 1024; };
    const Vec3d p{exact(point.x), exact(point.y), exact(point.z)};
    EXPECT_EQ(gradient_noise(p), gradient_noise(p + Vec3d{256, 0, 0}));
    EXPECT_EQ(gradient_noise(p), gradient_noise(p + Vec3d{0, -512, 0}));
    EXPECT_EQ(gradient_noise(p), gradient_noise(p + Vec3d{0, 0, 1024}));
  }
}

TEST(GradientNoise, FarAwayIsANumberAndNanIsNone) {
  for (const double far : {1e9, 1e15, 1e30, -1e30})
    EXPECT_TRUE(std::isfinite(gradient_noise({far, -far, far / 3})));
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(gradient_noise({nan, 0, 0})));
  EXPECT_TRUE(std::isnan(gradient_noise({0, std::numeric_limits<double>::infinity(), 0})));
}

TEST(Turbulence, IsTheSumOfItsOctaves) {
  Random random(304);
  for (int i = 0; i < 1000; ++i) {
    const Vec3d p = random.point(30);
    double sum = 0;
    for (const double f : {1.0, 2.0, 4.0, 8.0, 16.0, 32.0})
      sum += std::fabs(gradient_noise(p * f)) / f;
    EXPECT_EQ(turbulence_at(p), sum);
    EXPECT_GE(sum, 0);
    EXPECT_LT(sum, 2.1);
  }
  EXPECT_EQ(turbulence_at({3, -4, 5}), 0);
}

}  // namespace
}  // namespace tia
