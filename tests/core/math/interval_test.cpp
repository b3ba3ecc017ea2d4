#include "core/math/interval_functions.h"

#include <gtest/gtest.h>

#include "tests/core/math/enclosure.h"

namespace tia {
namespace {

using test::expect_law;
using test::Law;
using test::Long;
using test::Section;

constexpr Long exact_pi = 3.14159265358979323846264338327950288L;

bool holds_zero_inside(const Section& a, const Section&) { return a.lo < 0 && a.hi > 0; }
bool is_one_sided(const Section& a, const Section& b) { return !holds_zero_inside(a, b); }

// ---- arithmetic -----------------------------------------------------------------------------

TEST(Interval, SumsHoldWhatTheyMust) {
  expect_law([](auto a, auto b, auto&) { return a + b; }, {[](Long a, Long b) { return a + b; }},
             1);
  expect_law([](auto a, auto b, auto&) { return a - b; }, {[](Long a, Long b) { return a - b; }},
             2);
  expect_law([](auto a, auto, auto&) { return -a; }, {[](Long a, Long) { return -a; }}, 3);
}

TEST(Interval, ProductsHoldWhatTheyMust) {
  expect_law([](auto a, auto b, auto&) { return a * b; }, {[](Long a, Long b) { return a * b; }},
             4);
}

TEST(Interval, QuotientsHoldWhatTheyMust) {
  Law law{[](Long a, Long b) { return a / b; }};
  law.breaks = [](const Section&, const Section& b) { return b.holds(0); };
  // Beyond, inverses have few digits.
  law.corners = [](const Section&, const Section& b) {
    return std::max(-b.lo, b.hi) < 1e290 && std::max(b.lo, -b.hi) > 1e-290;
  };
  law.slack = 16 * 0x1p-52;
  expect_law([](auto a, auto b, auto& where) { return quotient(a, b, where); }, law, 5);
}

TEST(Interval, WholePowersHoldWhatTheyMust) {
  for (const int n : {1, 2, 3, 4, 7, 12, 31, 200, 256}) {
    Law law{[n](Long a, Long) { return std::pow(a, static_cast<Long>(n)); }};
    if (n % 2 == 0) law.corners = is_one_sided;
    law.slack = 4 * (n + 1) * 0x1p-52;
    expect_law([n](auto a, auto, auto&) { return whole_power(a, n); }, law, 6, 16'000);
  }
}

TEST(Interval, RootsHoldWhatTheyMust) {
  expect_law([](auto a, auto, auto& where) { return sqrt_of(a, where); },
             {[](Long a, Long) { return std::sqrt(a); }}, 7);
}

TEST(Interval, ChoicesHoldWhatTheyMust) {
  Law magnitude{[](Long a, Long) { return std::fabs(a); }};
  magnitude.corners = is_one_sided;
  expect_law([](auto a, auto, auto&) { return abs_of(a); }, magnitude, 8);
  expect_law([](auto a, auto b, auto&) { return lesser(a, b); },
             {[](Long a, Long b) { return std::min(a, b); }}, 9);
  expect_law([](auto a, auto b, auto&) { return greater(a, b); },
             {[](Long a, Long b) { return std::max(a, b); }}, 10);
}

TEST(Interval, FloorsHoldWhatTheyMust) {
  Law law{[](Long a, Long) { return std::floor(a); }};
  law.breaks = [](const Section& a, const Section&) {
    return std::floor(a.lo) != std::floor(a.hi);
  };
  expect_law([](auto a, auto, auto& where) { return floor_of(a, where); }, law, 11);
}

// ---- exponentials ---------------------------------------------------------------------------

TEST(Interval, ExponentialsAndLogarithmsHoldWhatTheyMust) {
  expect_law([](auto a, auto, auto&) { return exp_of(a); },
             {[](Long a, Long) { return std::exp(a); }}, 12);
  Law law{[](Long a, Long) { return std::log(a); }};
  law.breaks = [](const Section& a, const Section&) { return a.lo <= 0; };
  expect_law([](auto a, auto, auto& where) { return log_of(a, where); }, law, 13);
}

TEST(Interval, HyperbolicsHoldWhatTheyMust) {
  Law even{[](Long a, Long) { return std::cosh(a); }};
  even.corners = is_one_sided;
  expect_law([](auto a, auto, auto&) { return cosh_of(a); }, even, 14);
  expect_law([](auto a, auto, auto&) { return sinh_of(a); },
             {[](Long a, Long) { return std::sinh(a); }}, 15);
  expect_law([](auto a, auto, auto&) { return tanh_of(a); },
             {[](Long a, Long) { return std::tanh(a); }}, 16);
}

TEST(Interval, PowersHoldWhatTheyMust) {
  const auto undefined = std::numeric_limits<Long>::quiet_NaN();
  Law law{[=](Long a, Long b) { return a < 0 ? undefined : std::pow(std::fabs(a), b); }};
  law.breaks = [](const Section& a, const Section& b) {
    return a.lo < 0 || (a.holds(0) && b.lo < 0);
  };
  expect_law([](auto a, auto b, auto& where) { return pow_of(a, b, where); }, law, 17, 160'000);
}

// ---- angles ---------------------------------------------------------------------------------

// Whether offset + k period, for some whole k, lies in the box; or comes near it.
bool meets(const Section& a, Long offset, Long period, Long near = 0) {
  if (std::isinf(a.lo) || std::isinf(a.hi)) return true;
  const Long from = std::ceil((a.lo - offset) / period - near);
  return from * period + offset <= a.hi + near * period;
}

TEST(Interval, SinesAndCosinesHoldWhatTheyMust) {
  const auto monotone = [](Long offset) {
    return [offset](const Section& a, const Section&) {
      return std::max(-a.lo, a.hi) < 1e9 && !meets(a, offset, exact_pi, 1e-5L);
    };
  };
  Law sine{[](Long a, Long) { return std::sin(a); }};
  sine.corners = monotone(exact_pi / 2);
  sine.slack = 24 * 0x1p-52;  // of functions within 3.5 ulp, rounded outwards by 2^-49
  expect_law([](auto a, auto, auto&) { return sin_of(a); }, sine, 18);
  Law cosine{[](Long a, Long) { return std::cos(a); }};
  cosine.corners = monotone(0);
  cosine.slack = sine.slack;
  expect_law([](auto a, auto, auto&) { return cos_of(a); }, cosine, 19);
}

TEST(Interval, TangentsHoldWhatTheyMust) {
  Law law{[](Long a, Long) { return std::tan(a); }};
  law.breaks = [](const Section& a, const Section&) { return meets(a, exact_pi / 2, exact_pi); };
  expect_law([](auto a, auto, auto& where) { return tan_of(a, where); }, law, 20);
}

TEST(Interval, ArcFunctionsHoldWhatTheyMust) {
  expect_law([](auto a, auto, auto& where) { return asin_of(a, where); },
             {[](Long a, Long) { return std::asin(a); }}, 21);
  expect_law([](auto a, auto, auto& where) { return acos_of(a, where); },
             {[](Long a, Long) { return std::acos(a); }}, 22);
  expect_law([](auto a, auto, auto&) { return atan_of(a); },
             {[](Long a, Long) { return std::atan(a); }}, 23);
}

TEST(Interval, AnglesOfPointsHoldWhatTheyMust) {
  Law law{[](Long y, Long x) { return std::atan2(y, x); }};
  law.breaks = [](const Section& y, const Section& x) { return y.holds(0) && x.lo <= 0; };
  expect_law([](auto y, auto x, auto& where) { return atan2_of(y, x, where); }, law, 24, 160'000);
}

}  // namespace
}  // namespace tia
