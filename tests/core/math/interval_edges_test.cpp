// Intervals where their functions are special: at infinite bounds, poles, jumps and cuts, where
// doubles overflow and where they thin out.
#include <gtest/gtest.h>

#include "tests/core/math/enclosure.h"

namespace tia {
namespace {

using test::infinite;
using test::largest;
using test::Long;
using Range = Interval<double>;

const Range whole_line{-infinite, infinite}, half_line{0, infinite};
constexpr double smallest_double = 5e-324;

void expect_about(const Range& got, double lo, double hi) {
  if (std::isinf(lo)) EXPECT_EQ(got.lo, lo);
  else EXPECT_NEAR(got.lo, lo, 1e-14 * std::fabs(lo) + 1e-300);
  if (std::isinf(hi)) EXPECT_EQ(got.hi, hi);
  else EXPECT_NEAR(got.hi, hi, 1e-14 * std::fabs(hi) + 1e-300);
}
bool holds(const Range& range, Long x) { return range.lo <= x && x <= range.hi; }

TEST(IntervalEdges, InfiniteBoundsAreNoNumbers) {
  expect_about(half_line - half_line, -infinite, infinite);
  expect_about(half_line + Range(-infinite, 0), -infinite, infinite);
  expect_about(Range(0, 0) * whole_line, 0, 0);
  expect_about(half_line * Range(-1, 0), -infinite, 0);
  expect_about(half_line * half_line, 0, infinite);
  expect_about(whole_line * Range(2, 3), -infinite, infinite);
  expect_about(enclosed_quotient(Range(1, 2), Range(4, infinite)), 0, 0.5);
  expect_about(enclosed_quotient(half_line, Range(4, infinite)), 0, infinite);
  expect_about(whole_power(whole_line, 2), 0, infinite);
  expect_about(whole_power(whole_line, 3), -infinite, infinite);
}

TEST(IntervalEdges, FunctionsReachTheirLimits) {
  Definedness<double> where;
  expect_about(exp_of(whole_line), 0, infinite);
  expect_about(exp_of(Range(-infinite, 0)), 0, 1);
  expect_about(log_of(half_line, where), -infinite, infinite);
  expect_about(sqrt_of(half_line, where), 0, infinite);
  expect_about(sin_of(whole_line), -1, 1);
  expect_about(cos_of(half_line), -1, 1);
  expect_about(tan_of(half_line, where), -infinite, infinite);
  expect_about(atan_of(whole_line), -pi / 2, pi / 2);
  expect_about(tanh_of(whole_line), -1, 1);
  expect_about(sinh_of(whole_line), -infinite, infinite);
  expect_about(cosh_of(whole_line), 1, infinite);
  expect_about(asin_of(whole_line, where), -pi / 2, pi / 2);
  expect_about(acos_of(whole_line, where), 0, pi);
  expect_about(pow_of(half_line, half_line, where), 0, infinite);
  expect_about(pow_of(Range(0.25, 0.5), half_line, where), 0, 1);
  expect_about(pow_of(Range(2, infinite), Range(-infinite, -1), where), 0, 0.5);
  expect_about(atan2_of(Range(1, infinite), Range(1, infinite), where), 0, pi / 2);
}

TEST(IntervalEdges, SumsThatOverflowHoldWhatTheyWouldBe) {
  const Range great(largest, largest);
  EXPECT_TRUE(holds(great + great, 2 * static_cast<Long>(largest)));
  EXPECT_TRUE(holds(great * great, static_cast<Long>(largest) * largest));
  EXPECT_TRUE(holds(whole_power(great, 3), std::pow(static_cast<Long>(largest), 3.0L)));
  EXPECT_TRUE(holds(exp_of(Range(710, 711)), std::exp(710.5L)));
  EXPECT_TRUE(holds(sinh_of(Range(710.2)), std::sinh(710.2L)));
  EXPECT_TRUE(holds(sinh_of(Range(-710.2)), -std::sinh(710.2L)));
  EXPECT_TRUE(holds(cosh_of(Range(-710.2)), std::cosh(710.2L)));
  EXPECT_LT((great + great).lo, infinite);
  EXPECT_GT((-great - great).hi, -infinite);
}

TEST(IntervalEdges, WhatThinsOutIsHeld) {
  const Range small(smallest_double, 3 * smallest_double);
  EXPECT_TRUE(holds(small * small, static_cast<Long>(smallest_double) * smallest_double));
  EXPECT_TRUE(holds(small * Range(0.5, 0.5), static_cast<Long>(smallest_double) * 0.5L));
  EXPECT_TRUE(holds(whole_power(Range(1e-200), 2), 1e-400L));
  EXPECT_TRUE(holds(exp_of(Range(-800)), std::exp(-800.0L)));
  EXPECT_TRUE(holds(enclosed_quotient(small, Range(3)), static_cast<Long>(smallest_double) / 3));
  EXPECT_TRUE(
      holds(enclosed_quotient(Range(1), small), 1 / static_cast<Long>(2 * smallest_double)));
}

TEST(IntervalEdges, WavesReachTheirExtremesWhereTheBoxMeetsThem) {
  EXPECT_EQ(sin_of(Range(1.5, 1.6)).hi, 1);
  EXPECT_EQ(sin_of(Range(-1.6, -1.5)).lo, -1);
  EXPECT_LT(sin_of(Range(1.6, 1.7)).hi, 0.9997);
  EXPECT_EQ(cos_of(Range(-0.1, 0.1)).hi, 1);
  EXPECT_EQ(cos_of(Range(3.1, 3.2)).lo, -1);
  expect_about(sin_of(Range(0, 7)), -1, 1);
  for (const double turns : {1.0, 1e3, 1e6, -1e6}) {
    const double top = (turns + 0.25) * 2 * pi;
    EXPECT_EQ(sin_of(Range(top - 0.1, top + 0.1)).hi, 1);
    EXPECT_GT(sin_of(Range(top - 0.1, top + 0.1)).lo, 0.99);
  }
}

TEST(IntervalEdges, WavesOfGreatAnglesAreHeld) {
  for (const double x : {1e9, 1.1e9, 1e15, 1e22, 1e300, largest}) {
    EXPECT_TRUE(holds(sin_of(Range(x)), std::sin(static_cast<Long>(x)))) << x;
    EXPECT_TRUE(holds(cos_of(Range(-x)), std::cos(static_cast<Long>(x)))) << x;
    EXPECT_NEAR(sin_of(x), static_cast<double>(std::sin(static_cast<Long>(x))), 1e-15) << x;
  }
}

TEST(IntervalEdges, TangentsAreWholeBetweenPolesAlone) {
  const auto whole = [](double lo, double hi) {
    Definedness<double> where;
    tan_of(Range(lo, hi), where);
    return where.whole;
  };
  EXPECT_TRUE(whole(-1.57, 1.57));
  EXPECT_TRUE(whole(1.58, 4.71));
  EXPECT_FALSE(whole(1.57, 1.58));
  EXPECT_FALSE(whole(pi / 2, pi / 2));
  EXPECT_FALSE(whole(1, 5));
  EXPECT_FALSE(whole(0, infinite));
}

TEST(IntervalEdges, FloorsAreWholeOnOneStep) {
  const auto whole = [](double lo, double hi) {
    Definedness<double> where;
    const Range steps = floor_of(Range(lo, hi), where);
    EXPECT_EQ(steps.lo, std::floor(lo));
    EXPECT_EQ(steps.hi, std::floor(hi));
    return where.whole;
  };
  EXPECT_TRUE(whole(1, 1.99));
  EXPECT_TRUE(whole(2, 2));
  EXPECT_FALSE(whole(1.99, 2));
  EXPECT_FALSE(whole(-smallest_double, 0));
  EXPECT_TRUE(whole(-0.5, -smallest_double));
}

TEST(IntervalEdges, AnglesAreCutAlongTheNegativeAxis) {
  const auto whole = [](const Range& y, const Range& x) {
    Definedness<double> where;
    const Range angle = atan2_of(y, x, where);
    if (!where.whole) expect_about(angle, -pi, pi);
    return where.whole;
  };
  EXPECT_FALSE(whole({-1, 1}, {-2, -1}));
  EXPECT_FALSE(whole({0, 1}, {-2, -1}));
  EXPECT_FALSE(whole({-1, -0.0}, {-2, -1}));
  EXPECT_FALSE(whole({0, 0}, {0, 0}));
  EXPECT_FALSE(whole({-1, 1}, {0, 1}));
  EXPECT_TRUE(whole({-1, 1}, {smallest_double, 1}));
  EXPECT_TRUE(whole({smallest_double, 1}, {-2, 2}));
  EXPECT_TRUE(whole({-1, -smallest_double}, {-2, 2}));
}

TEST(IntervalEdges, PowersAreWholeFromZeroUp) {
  const auto where_is = [](const Range& a, const Range& b) {
    Definedness<double> where;
    pow_of(a, b, where);
    return where;
  };
  EXPECT_TRUE(where_is({0, 4}, {0.5, 1}).whole);
  EXPECT_TRUE(where_is({smallest_double, 4}, {-1, 1}).whole);
  EXPECT_FALSE(where_is({0, 4}, {-1, 1}).whole);
  EXPECT_FALSE(where_is({0, 4}, {0, 1}).whole);  // 0^0 is 1, 0^b is 0
  EXPECT_FALSE(where_is({-1, 4}, {2, 2}).whole);
  EXPECT_TRUE(where_is({-1, 0}, {2, 2}).some);
  EXPECT_FALSE(where_is({-2, -1}, {2, 2}).some);
}

TEST(IntervalEdges, RootsAndLogarithmsKnowTheirDomains) {
  const auto roots = [](const Range& a) {
    Definedness<double> where;
    sqrt_of(a, where);
    return where.whole ? 2 : where.some ? 1 : 0;
  };
  EXPECT_EQ(roots({0, 1}), 2);
  EXPECT_EQ(roots({-0.0, 1}), 2);
  EXPECT_EQ(roots({-1, 0}), 1);
  EXPECT_EQ(roots({-1, -smallest_double}), 0);
  const auto logarithms = [](const Range& a) {
    Definedness<double> where;
    log_of(a, where);
    return where.whole ? 2 : where.some ? 1 : 0;
  };
  EXPECT_EQ(logarithms({smallest_double, 1}), 2);
  EXPECT_EQ(logarithms({0, 1}), 1);
  EXPECT_EQ(logarithms({-2, -1}), 0);
}

TEST(IntervalEdges, DefinednessGathers) {
  Definedness<double> where;
  sqrt_of(Range(0, 1), where);
  EXPECT_TRUE(where.whole && where.some);
  sqrt_of(Range(-1, 1), where);
  sqrt_of(Range(0, 1), where);
  EXPECT_TRUE(!where.whole && where.some);
  log_of(Range(-2, -1), where);
  log_of(Range(1, 2), where);
  EXPECT_TRUE(!where.whole && !where.some);
}

TEST(IntervalEdges, MiddlesAreInside) {
  test::Random random(1);
  for (int i = 0; i < 10'000; ++i) {
    const double from = random.in(-1, 1) * std::pow(10, random.in(-300, 308));
    for (const double to : {from, std::nextafter(from, infinite), from * (1 + random.unit())}) {
      const Range range(std::min(from, to), std::max(from, to));
      ASSERT_TRUE(holds(range, range.middle())) << range.lo << ", " << range.hi;
    }
  }
  EXPECT_EQ(Range(-largest, largest).middle(), 0);
  EXPECT_EQ(Range(largest, largest).middle(), largest);
}

TEST(IntervalEdges, HullAndCommonPart) {
  expect_about(hull(Range(1, 3), Range(2, 4)), 1, 4);
  expect_about(hull(Range(1, 2), Range(5, 6)), 1, 6);
  expect_about(common(Range(1, 3), Range(2, 4)), 2, 3);
}

}  // namespace
}  // namespace tia
