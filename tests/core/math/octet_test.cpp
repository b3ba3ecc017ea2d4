#include "core/math/octet.h"

#include <gtest/gtest.h>

#include <array>

#include "core/formulas/scalars.h"
#include "tests/core/support.h"

namespace tia {
namespace {

using test::Random;
using Eight = std::array<double, 8>;

constexpr double infinite_double = std::numeric_limits<double>::infinity();

Octet octet_of(const Eight& from) { return Octet::load_unaligned(from.data()); }
std::uint64_t double_bits(double x) { return std::bit_cast<std::uint64_t>(x); }

// Numbers at which a function may do something of its own.
constexpr std::array specials{0.0,
                              -0.0,
                              1.0,
                              -1.0,
                              0.5,
                              -0.5,
                              2.0,
                              -2.0,
                              3.0,
                              -3.0,
                              1e-320,
                              -1e-320,
                              1e-308,
                              1e308,
                              -1e308,
                              infinite_double,
                              -infinite_double,
                              std::numeric_limits<double>::quiet_NaN(),
                              709.79,
                              -745.2,
                              710.4,
                              1e9,
                              -1e15,
                              0.9999999999999999,
                              1.0000000000000002,
                              1e300,
                              4503599627370496.5,
                              1.5707963267948966,
                              3.141592653589793};

// Of any bits, special, or of a size at which functions are not mere limits.
double any_double(Random& random) {
  const double kind = random.unit();
  if (kind < 0.25) {
    const auto high = static_cast<std::uint64_t>(random.unit() * 0x1p32);
    return std::bit_cast<double>(high << 32U | static_cast<std::uint64_t>(random.unit() * 0x1p32));
  }
  if (kind < 0.5)
    return specials[static_cast<std::size_t>(random.below(static_cast<int>(specials.size())))];
  const double size = std::pow(10, random.in(-6, 4));
  return random.in(-size, size);
}

// What a function makes of eight numbers is what it makes of each, to the bit; which of several NaN
// that are is the processor's own affair.
template <class F>
void expect_octets_agree(F f, int times = 20'000) {
  Random random(7);
  for (int i = 0; i < times; ++i) {
    Eight a{}, b{};
    for (double& each : a) each = any_double(random);
    for (double& each : b) each = any_double(random);
    const Octet all = f(octet_of(a), octet_of(b));
    for (std::size_t k = 0; k < 8; ++k) {
      const double alone = f(a[k], b[k]), among = lane(all, static_cast<int>(k));
      if (std::isnan(alone)) ASSERT_TRUE(std::isnan(among)) << a[k] << ", " << b[k];
      else ASSERT_EQ(double_bits(among), double_bits(alone)) << a[k] << ", " << b[k];
    }
  }
}

TEST(Octet, ArithmeticIsDoublesBitForBit) {
  expect_octets_agree([](auto a, auto b) { return a + b; });
  expect_octets_agree([](auto a, auto b) { return a - b; });
  expect_octets_agree([](auto a, auto b) { return a * b; });
  expect_octets_agree([](auto a, auto b) { return a / b; });
  expect_octets_agree([](auto a, auto) { return -a; });
  expect_octets_agree([](auto a, auto) {
    using std::sqrt;
    return sqrt(a);
  });
}

TEST(Octet, ChoicesAreDoublesBitForBit) {
  expect_octets_agree([](auto a, auto) { return abs_of(a); });
  expect_octets_agree([](auto a, auto) { return floor_of(a); });
  expect_octets_agree([](auto a, auto b) { return max_of(a, b); });
  expect_octets_agree([](auto a, auto b) { return min_of(a, b); });
  expect_octets_agree([](auto a, auto b) { return lesser(a, b); });
  expect_octets_agree([](auto a, auto b) { return greater(a, b); });
  expect_octets_agree([](auto a, auto b) { return select(a < b, a, b); });
}

TEST(Octet, AnglesAreDoublesBitForBit) {
  expect_octets_agree([](auto a, auto) { return sincos_of(a).sine; });
  expect_octets_agree([](auto a, auto) { return sincos_of(a).cosine; });
  expect_octets_agree([](auto a, auto) { return tan_of(a); });
  expect_octets_agree([](auto a, auto) { return asin_of(a); });
  expect_octets_agree([](auto a, auto) { return acos_of(a); });
  expect_octets_agree([](auto a, auto) { return atan_of(a); });
  expect_octets_agree([](auto a, auto b) { return atan2_of(a, b); });
}

TEST(Octet, PowersAreDoublesBitForBit) {
  expect_octets_agree([](auto a, auto) { return sinh_of(a); });
  expect_octets_agree([](auto a, auto) { return cosh_of(a); });
  expect_octets_agree([](auto a, auto) { return tanh_of(a); });
  expect_octets_agree([](auto a, auto) { return exp_of(a); });
  expect_octets_agree([](auto a, auto) { return log_of(a); });
  expect_octets_agree([](auto a, auto b) { return pow_of(a, b); });
  expect_octets_agree([](auto a, auto b) {
    Anywhere where;
    return pow_of(a, b, where);
  });
  expect_octets_agree([](auto a, auto) { return whole_power(a, 7); });
}

TEST(Octet, ComparisonsAreDoublesLaneByLane) {
  Random random(8);
  for (int i = 0; i < 20'000; ++i) {
    Eight a{}, b{};
    for (double& each : a) each = any_double(random);
    for (double& each : b) each = random.chance(0.5) ? any_double(random) : a[3];
    const unsigned less = bits(octet_of(a) < octet_of(b)), same = bits(octet_of(a) == octet_of(b));
    const unsigned neither = bits(!(octet_of(a) <= octet_of(b)) && !(octet_of(a) > octet_of(b)));
    for (unsigned k = 0; k < 8; ++k) {
      ASSERT_EQ((less >> k & 1U) != 0, a[k] < b[k]);
      ASSERT_EQ((same >> k & 1U) != 0, a[k] == b[k]);
      ASSERT_EQ((neither >> k & 1U) != 0, !(a[k] <= b[k]) && !(a[k] > b[k]));
    }
    ASSERT_EQ((less | same | neither) >> 8U, 0U);
  }
}

TEST(Octet, LesserAndGreaterOfNanAreNan) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double x : {-infinite_double, -1.0, 0.0, 1.0, infinite_double}) {
    EXPECT_TRUE(std::isnan(lesser(nan, x)) && std::isnan(lesser(x, nan)));
    EXPECT_TRUE(std::isnan(greater(nan, x)) && std::isnan(greater(x, nan)));
  }
}

TEST(Octet, PowersOfNanAreNan) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Anywhere where;
  for (const double x : {0.0, 1.0, 2.0, infinite_double}) {
    EXPECT_TRUE(std::isnan(pow_of(nan, x, where))) << x;
    EXPECT_TRUE(std::isnan(pow_of(x, nan, where))) << x;
  }
}

TEST(Octet, PowersOfMinusZeroAreThoseOfZero) {
  Anywhere where;
  EXPECT_EQ(pow_of(-0.0, -3.0, where), infinite_double);
  EXPECT_EQ(double_bits(pow_of(-0.0, 3.0, where)), double_bits(0.0));
}

}  // namespace
}  // namespace tia
