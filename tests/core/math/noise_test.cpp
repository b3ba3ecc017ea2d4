#include "core/math/noise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string_view>

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

// ---- the same noise by another road: a sum over the eight corners, every gradient written out
// ----

// The published permutation, two hexadecimal digits a number.
constexpr std::string_view published =
    "97a0895b5a0f830dc95f6035c2e907e18c24671e458e086325f0150a17be0694"
    "f778ea4b001ac53e5efcdbcb75230b2039b12158ed953857ae147d88aba844af"
    "4aa547868b301ba64d929ee7536fe57a3cd385e6dc695c29372ef528f4668f36"
    "41193fa101d85049d14c84bbd05912a9c8c4878274bc9f56a4646dc6adba0340"
    "34d9e2fa7c7b05ca2693767eff5255d4cfce3be32f103a11b6bd1c2adfb7aad5"
    "77f898022c9aa346dd99659ba72bac09811627fd13626c6e4f71e0e8b2b97068"
    "daf661e4fb22f2c1eed2900cbfb3a2f1513391ebf90eef6b31c0d61fb5c76a9d"
    "b854ccb07379322d7f0496fe8aeccd5dde72431d1848f38d80c34e42d73d9cb4";

int published_at(int i) {
  const auto digit = [&](int at) {
    const char c = published[static_cast<std::size_t>(2 * (i & 255) + at)];
    return c <= '9' ? c - '0' : c - 'a' + 10;
  };
  return 16 * digit(0) + digit(1);
}

double reference_noise(const Vec3d& p) {
  const Vec3d gradients[] = {{1, 1, 0}, {-1, 1, 0}, {1, -1, 0}, {-1, -1, 0},
                             {1, 0, 1}, {-1, 0, 1}, {1, 0, -1}, {-1, 0, -1},
                             {0, 1, 1}, {0, -1, 1}, {0, 1, -1}, {0, -1, -1},
                             {1, 1, 0}, {0, -1, 1}, {-1, 1, 0}, {0, -1, -1}};
  const auto weight = [](double distance) {  // 1 at the corner, 0 from 1 on
    const double t = 1 - std::fabs(distance);
    return 6 * t * t * t * t * t - 15 * t * t * t * t + 10 * t * t * t;
  };
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3d at{std::floor(p.x) + corner % 2, std::floor(p.y) + corner / 2 % 2,
                   std::floor(p.z) + corner / 4};
    int hash = 0;
    for (const double axis : {at.x, at.y, at.z})
      hash = published_at(hash + (static_cast<int>(axis) & 255));
    const Vec3d from = p - at;
    sum += weight(from.x) * weight(from.y) * weight(from.z) * dot(gradients[hash % 16], from);
  }
  return sum;
}

TEST(GradientNoise, IsTheSumOverTheCornersOfACell) {
  Random random(305);
  for (int i = 0; i < 20'000; ++i) {
    const Vec3d p = random.point(i % 2 == 0 ? 3 : 600);
    ASSERT_NEAR(gradient_noise(p), reference_noise(p), 1e-13);
  }
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
