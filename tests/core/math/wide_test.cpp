#include "core/math/lanes.h"

#include <gtest/gtest.h>

#include <array>

#include "tests/core/support.h"

namespace tia {
namespace {

using test::Random;
constexpr int lane_count = lanes<Wide>;
using Lanes = std::array<float, lane_count>;

Wide wide_of(const Lanes& from) { return Wide::load_unaligned(from.data()); }
std::uint32_t float_bits(float f) { return std::bit_cast<std::uint32_t>(f); }

// Random bit patterns: every exponent, denormals, infinities and NaN among them.
float any_float(Random& random) {
  return std::bit_cast<float>(static_cast<std::uint32_t>(random.unit() * 0x1p32));
}
Lanes any_lanes(Random& random) {
  Lanes out{};
  for (float& lane : out) lane = any_float(random);
  return out;
}

// One float operation and its Wide counterpart agree in every lane; any NaN equals any other, for
// which of two NaN operands survives is the processor's own affair.
template <class F>
void expect_lanes_agree(F f) {
  Random random(5);
  for (int i = 0; i < 20'000; ++i) {
    const Lanes a = any_lanes(random), b = any_lanes(random);
    const Wide wide = f(wide_of(a), wide_of(b));
    for (int k = 0; k < lane_count; ++k) {
      const auto at = static_cast<std::size_t>(k);
      const float alone = f(a[at], b[at]), among = lane(wide, k);
      if (std::isnan(alone)) EXPECT_TRUE(std::isnan(among)) << a[at] << ", " << b[at];
      else EXPECT_EQ(float_bits(among), float_bits(alone)) << a[at] << ", " << b[at];
    }
  }
}

TEST(Wide, ArithmeticIsFloatsBitForBit) {
  expect_lanes_agree([](auto a, auto b) { return a + b; });
  expect_lanes_agree([](auto a, auto b) { return a - b; });
  expect_lanes_agree([](auto a, auto b) { return a * b; });
  expect_lanes_agree([](auto a, auto b) { return a / b; });
  expect_lanes_agree([](auto a, auto) {
    using std::sqrt;
    return sqrt(a);
  });
  expect_lanes_agree([](auto a, auto) { return abs_of(a); });
  expect_lanes_agree([](auto a, auto) { return -a; });
}

TEST(Wide, ProductsAndSumsAreNotFused) {
  // 1 + 2^-12 squared is 1 + 2^-11 + 2^-24: rounded first, the last term is lost.
  volatile float not_constant = 1 + 0x1p-12F;
  const float a = not_constant, b = -(1 + 0x1p-11F);
  EXPECT_EQ(a * a + b, 0);
  EXPECT_EQ(lane(Wide(a) * Wide(a) + Wide(b), 0), 0);
}

TEST(Wide, SelectAndMaximumAreFloatsBitForBit) {
  expect_lanes_agree([](auto a, auto b) { return select(a < b, a, b); });
  expect_lanes_agree([](auto a, auto b) { return select(!(a >= b), b, a); });
  expect_lanes_agree([](auto a, auto b) { return max_of(a, b); });
}

TEST(Wide, MaximumOfNumbersThatDoNotCompareIsTheSecond) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(max_of(nan, 1.0F), 1);
  EXPECT_TRUE(std::isnan(max_of(1.0F, nan)));
}

TEST(Wide, MaskBitsHaveLaneZeroLowest) {
  for (int k = 0; k < lane_count; ++k) {
    const WideMask mask = iota<Wide>() == Wide(static_cast<float>(k));
    EXPECT_EQ(bits(mask), 1U << static_cast<unsigned>(k));
    EXPECT_TRUE(any(mask));
    EXPECT_EQ(count(mask), 1);
    EXPECT_EQ(count(!mask), lane_count - 1);
  }
  EXPECT_FALSE(any(WideMask(false)));
  EXPECT_EQ(count(WideMask(true)), lane_count);
  EXPECT_EQ(bits(true), 1U);
  EXPECT_EQ(count(false), 0);
}

TEST(Wide, StoreAndLaneGiveBackWhatWasLoaded) {
  Random random(6);
  const Lanes in = any_lanes(random);
  Lanes out{};
  store(wide_of(in), out.data());
  for (int k = 0; k < lane_count; ++k) {
    const auto at = static_cast<std::size_t>(k);
    EXPECT_EQ(float_bits(out[at]), float_bits(in[at]));
    EXPECT_EQ(float_bits(lane(wide_of(in), k)), float_bits(in[at]));
  }
}

TEST(Wide, ThroughDoubleAndBackKeepsEveryLane) {
  Random random(7);
  for (int i = 0; i < 20'000; ++i) {
    const Lanes in = any_lanes(random);
    const Wide out = narrow<Wide>(widen(wide_of(in)));
    for (int k = 0; k < lane_count; ++k) {
      const float was = in[static_cast<std::size_t>(k)];
      if (std::isnan(was)) EXPECT_TRUE(std::isnan(lane(out, k)));
      else EXPECT_EQ(float_bits(lane(out, k)), float_bits(was));
    }
  }
}

TEST(Wide, DoubleLanesRoundOnceLikeDouble) {
  Random random(8);
  for (int i = 0; i < 20'000; ++i) {
    Lanes a{}, b{};
    for (float& x : a) x = static_cast<float>(random.in(0.1, 1e4));
    for (float& x : b) x = static_cast<float>(random.in(-1e4, 1e4));
    const auto f = [](auto x, auto y) {
      using std::sqrt;
      return sqrt(x) * y - x * x + y;
    };
    const Wide wide = narrow<Wide>(f(widen(wide_of(a)), widen(wide_of(b))));
    for (int k = 0; k < lane_count; ++k) {
      const auto at = static_cast<std::size_t>(k);
      const double alone = f(widen(a[at]), widen(b[at]));
      EXPECT_EQ(lane(wide, k), static_cast<float>(alone));
    }
  }
}

TEST(Wide, LiftRoundsOnceToFloatAndLeavesDoubleAlone) {
  const double third = 1.0 / 3;
  EXPECT_EQ(lift<float>(third), static_cast<float>(third));
  EXPECT_EQ(lane(lift<Wide>(third), lane_count - 1), static_cast<float>(third));
  EXPECT_EQ(lift<double>(third), third);
}

}  // namespace
}  // namespace tia
