#include "core/math/warp.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "core/math/deterministic.h"
#include "tests/core/support.h"

namespace tia {
namespace {

using test::Random;

TEST(SquareToDisc, EdgesAndCentreOfTheSquareGoToThoseOfTheDisc) {
  EXPECT_EQ(square_to_disc(0.5, 0.5).x, 0);
  EXPECT_EQ(square_to_disc(0.5, 0.5).y, 0);
  EXPECT_EQ(square_to_disc(1.0, 0.5).x, 1);
  EXPECT_EQ(square_to_disc(0.5, 0.0).y, -1);
  Random random(72);
  for (int i = 0; i < 1000; ++i) {
    const double along = random.unit();
    for (const auto& p : {square_to_disc(0.0, along), square_to_disc(1.0, along),
                          square_to_disc(along, 0.0), square_to_disc(along, 1.0)})
      EXPECT_NEAR(p.x * p.x + p.y * p.y, 1, 5e-8);
  }
}

TEST(SquareToDisc, SquaresOfEqualRadiusAndAngleFollowTheConcentricFormula) {
  // Shirley and Chiu: r = a, phi = pi/4 * b/a where |a| > |b|, else r = b, phi = pi/2 - pi/4 a/b.
  Random random(73);
  for (int i = 0; i < 5000; ++i) {
    const double u = random.unit(), v = random.unit();
    const double a = 2 * u - 1, b = 2 * v - 1;
    const bool flat = std::fabs(a) > std::fabs(b);
    const double r = flat ? a : b, phi = flat ? pi / 4 * (b / a) : pi / 2 - pi / 4 * (a / b);
    const auto p = square_to_disc(u, v);
    EXPECT_NEAR(p.x, r * std::cos(phi), 5e-8);
    EXPECT_NEAR(p.y, r * std::sin(phi), 5e-8);
    const auto f = square_to_disc(static_cast<float>(u), static_cast<float>(v));
    EXPECT_NEAR(f.x, p.x, 5e-7);
    EXPECT_NEAR(f.y, p.y, 5e-7);
  }
}

TEST(SquareToDisc, IsUniform) {
  // 8 rings of equal area times 8 sectors; chi-squared of 64 cells: 63 +- 11.2, here +- 5 sigma.
  Random random(74);
  constexpr int sampler_state = 64'000;
  std::array<int, 64> counts{};
  for (int i = 0; i < sampler_state; ++i) {
    const double u = random.unit();
    const auto p = square_to_disc(u, random.unit());
    const int ring = std::min(7, static_cast<int>(8 * (p.x * p.x + p.y * p.y)));
    const int sector = static_cast<int>((std::atan2(p.y, p.x) / pi + 1) * 4) % 8;
    ++counts[static_cast<std::size_t>(8 * ring + sector)];
  }
  double statistic = 0;
  for (const int count : counts) statistic += (count - 1000.0) * (count - 1000.0) / 1000;
  EXPECT_NEAR(statistic, 63, 5 * std::sqrt(2 * 63.0));
}

TEST(SquareToDisc, WideEqualsFloatBitForBit) {
  Random random(75);
  for (int i = 0; i < 200; ++i) {
    std::array<float, Wide::size> u, v;
    for (std::size_t k = 0; k < Wide::size; ++k) {
      u[k] = static_cast<float>(random.unit());
      v[k] = i == 0 ? 0.5F : static_cast<float>(random.unit());
    }
    if (i == 0) u[0] = 0.5F;
    const auto wide = square_to_disc(load<Wide>(u.data()), load<Wide>(v.data()));
    for (int k = 0; k < static_cast<int>(Wide::size); ++k) {
      const auto at = static_cast<std::size_t>(k);
      const auto one = square_to_disc(u[at], v[at]);
      EXPECT_EQ(std::bit_cast<std::uint32_t>(lane(wide.x, k)), std::bit_cast<std::uint32_t>(one.x));
      EXPECT_EQ(std::bit_cast<std::uint32_t>(lane(wide.y, k)), std::bit_cast<std::uint32_t>(one.y));
    }
  }
}

}  // namespace
}  // namespace tia
