#include "core/math/deterministic.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/core/support.h"

namespace tia {
namespace {

TEST(Deterministic, PiIsTheNearestDouble) { EXPECT_EQ(pi, static_cast<double>(std::acos(-1.0L))); }

TEST(Deterministic, TangentLiesWithinOneUlpOfTheExactOne) {
  test::Random random(3);
  for (int i = 0; i < 200'000; ++i) {
    const double x = random.in(-1.57, 1.57);
    const long double exact = std::tan(static_cast<long double>(x));
    const auto nearest = static_cast<double>(exact);
    const double ulp = std::nextafter(std::fabs(nearest), std::numeric_limits<double>::infinity()) -
                       std::fabs(nearest);
    EXPECT_LE(std::fabs(tan_of(x) - exact), static_cast<long double>(ulp)) << "tan " << x;
  }
}

TEST(Deterministic, TangentIsOddAndZeroAtZero) {
  test::Random random(4);
  EXPECT_EQ(tan_of(0), 0);
  for (int i = 0; i < 10'000; ++i) {
    const double x = random.in(0, 1.57);
    EXPECT_EQ(tan_of(-x), -tan_of(x));
  }
}

}  // namespace
}  // namespace tia
