#include "core/math/roots.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "tests/core/support.h"

namespace tia {
namespace {

using test::Long;
using test::Random;

// The coefficients of the product of (t - root), times a factor, lowest power first.
std::vector<double> polynomial_of(const std::vector<double>& roots, double factor = 1) {
  std::vector<Long> c{factor};
  for (const double root : roots) {
    c.push_back(0);
    for (std::size_t i = c.size() - 1; i > 0; --i) c[i] = c[i - 1] - static_cast<Long>(root) * c[i];
    c[0] *= -static_cast<Long>(root);
  }
  return {c.begin(), c.end()};
}
std::vector<double> roots_of(const std::vector<double>& c, double low, double high) {
  std::vector<double> found(c.size());
  found.resize(static_cast<std::size_t>(real_roots(c, low, high, found)));
  return found;
}
void expect_roots(const std::vector<double>& got, const std::vector<double>& expected,
                  double tolerance) {
  ASSERT_EQ(got.size(), expected.size()) << testing::PrintToString(got);
  for (std::size_t i = 0; i < got.size(); ++i) EXPECT_NEAR(got[i], expected[i], tolerance);
}

// ---- the quadratic ------------------------------------------------------------------------------

TEST(QuadraticRoots, AreThoseThatMadeIt) {
  Random random(1);
  for (const double scale : {1e-6, 1.0, 1e6}) {
    for (int i = 0; i < 1000; ++i) {
      const double r = random.in(-1, 1) * scale, gap = random.in(0.1, 1) * scale;
      const double a = random.chance(0.5) ? random.in(0.1, 10) : -random.in(0.1, 10);
      const QuadraticRoots found = quadratic_roots(a, -a * (r + r + gap) / 2, a * r * (r + gap));
      ASSERT_EQ(found.count, 2);
      EXPECT_NEAR(found.t0, r, 1e-14 * scale);
      EXPECT_NEAR(found.t1, r + gap, 1e-14 * scale);
    }
  }
}

// t^2 - 2e8 t + 1: the smaller root is 1 / (the larger), 5e-9 to the last digit but one; the
// schoolbook formula 1e8 - sqrt(1e16 - 1) has none of them.
TEST(QuadraticRoots, KeepTheDigitsOfTheSmallerRoot) {
  const QuadraticRoots found = quadratic_roots(1, -1e8, 1);
  ASSERT_EQ(found.count, 2);
  EXPECT_NEAR(found.t0 / 5e-9, 1, 1e-15);
  EXPECT_NEAR(found.t1 / 2e8, 1, 1e-15);
}

TEST(QuadraticRoots, TouchingCountsTwiceAndNoneIsNone) {
  const QuadraticRoots touching = quadratic_roots(4, -6, 9);  // (2t - 3)^2
  EXPECT_EQ(touching.count, 2);
  EXPECT_EQ(touching.t0, 1.5);
  EXPECT_EQ(touching.t1, 1.5);
  const QuadraticRoots origin = quadratic_roots(1, 0, 0);
  EXPECT_EQ(origin.count, 2);
  EXPECT_EQ(origin.t0, 0);
  EXPECT_EQ(origin.t1, 0);
  EXPECT_EQ(quadratic_roots(1, 0, 1).count, 0);
}

TEST(QuadraticRoots, OfALineAreOneOfAConstantNone) {
  const QuadraticRoots line = quadratic_roots(0, 2, -3);  // 4t - 3
  EXPECT_EQ(line.count, 1);
  EXPECT_EQ(line.t0, 0.75);
  EXPECT_EQ(quadratic_roots(0, 0, 1).count, 0);
  EXPECT_EQ(quadratic_roots(0, 0, 0).count, 0);
  EXPECT_EQ(quadratic_roots(std::nan(""), 1, 1).count, 0);
  EXPECT_EQ(quadratic_roots(1, 1, std::nan("")).count, 0);
}

// ---- any degree ---------------------------------------------------------------------------------

TEST(RealRoots, AreThoseThatMadeThePolynomial) {
  Random random(2);
  for (std::size_t degree = 1; degree <= 9; ++degree) {
    for (int i = 0; i < 100; ++i) {
      std::vector<double> roots;
      for (std::size_t k = 0; k < degree; ++k)  // at least 0.05 apart: well-conditioned
        roots.push_back(-1 + (static_cast<double>(k) + random.in(0.1, 0.8)) * 2 /
                                 static_cast<double>(degree));
      const std::vector<double> c = polynomial_of(roots, random.chance(0.5) ? 7 : -0.1);
      // The error of a root: the coefficients' rounding over the slope there.
      expect_roots(roots_of(c, -1, 1), roots, 1e-10);
    }
  }
}

TEST(RealRoots, AreThoseOfTheIntervalOnly) {
  const std::vector<double> c = polynomial_of({-3, -1, 0.5, 2, 4});
  expect_roots(roots_of(c, -2, 3), {-1, 0.5, 2}, 1e-14);
  expect_roots(roots_of(c, -10, 10), {-3, -1, 0.5, 2, 4}, 1e-14);
  expect_roots(roots_of(c, 0.6, 1.9), {}, 0);
  expect_roots(roots_of(c, 2, 4), {2, 4}, 1e-14);  // the ends belong to it
}

TEST(RealRoots, ScaleWithTheirInterval) {
  Random random(3);
  for (const double scale : {1e-6, 1e6}) {
    for (int i = 0; i < 100; ++i) {
      const double a = random.in(-1, -0.5), b = random.in(-0.3, 0.3), c = random.in(0.5, 1);
      const std::vector<double> roots{a * scale, b * scale, c * scale};
      expect_roots(roots_of(polynomial_of(roots), -2 * scale, 2 * scale), roots, 1e-14 * scale);
    }
  }
}

TEST(RealRoots, AreNoneWhereThePolynomialKeepsClearOfZero) {
  Random random(4);
  for (int i = 0; i < 500; ++i) {  // (t^2 + a)(t^2 + b t + c), both factors positive
    const double a = random.in(0.01, 2), b = random.in(-1, 1), c = b * b / 4 + random.in(0.01, 1);
    const std::vector<double> quartic{a * c, a * b, a + c, b, 1};
    EXPECT_TRUE(roots_of(quartic, -5, 5).empty());
  }
}

TEST(RealRoots, AreOddInNumberOnlyIfTheEndsDifferInSign) {
  Random random(5);
  for (int i = 0; i < 2000; ++i) {
    std::vector<double> c;
    for (int k = 0; k < 7; ++k) c.push_back(random.in(-1, 1));
    const auto value = [&](double t) {
      double v = 0;
      for (std::size_t k = c.size(); k-- > 0;) v = v * t + c[k];
      return v;
    };
    const std::vector<double> found = roots_of(c, -1.5, 1.5);
    EXPECT_EQ(found.size() % 2 == 1, value(-1.5) * value(1.5) < 0);
    EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
    for (const double root : found) EXPECT_NEAR(value(root), 0, 1e-13);
  }
}

// Roots of even order are touched: twice each, to the square root of the rounding at worst.
TEST(RealRoots, TouchingOnesStandTwice) {
  Random random(6);
  for (int i = 0; i < 500; ++i) {
    const double a = random.in(-1, -0.1), b = random.in(0.1, 1);
    expect_roots(roots_of(polynomial_of({a, a, b, b}), -3, 3), {a, a, b, b}, 1e-6);
    expect_roots(roots_of(polynomial_of({a, b, b}), -3, 3), {a, b, b}, 1e-6);
  }
}

// A root of order n is known to the n-th root of the rounding.
TEST(RealRoots, OfThirdAndFourthOrderStandOnceAndTwice) {
  expect_roots(roots_of(polynomial_of({0.3, 0.3, 0.3}), -1, 1), {0.3}, 1e-4);
  expect_roots(roots_of(polynomial_of({0.3, 0.3, 0.3, 0.3}), -1, 1), {0.3, 0.3}, 1e-3);
  expect_roots(roots_of({0, 0, 0, 0, 1}, -1, 1), {0, 0}, 0);
}

// Each alone in its bracket: a bracket ends where the next begins at the latest, p differs in sign
// at its ends, and one that touches is a point.
TEST(RealRoots, StandInTheirBrackets) {
  Random random(18);
  int touching = 0;
  for (int i = 0; i < 500; ++i) {
    std::vector<double> made(static_cast<std::size_t>(1 + random.below(8)));
    for (double& root : made) root = random.in(-0.9, 0.9);
    if (random.chance(0.3)) made.push_back(made.front());
    const std::vector<double> c = polynomial_of(made);
    std::array<double, max_degree> t;
    std::array<RootBracket, max_degree> brackets;
    const auto count = static_cast<std::size_t>(real_roots(c, -1, 1, t, brackets));
    const auto value = [&](double at) {
      Long sum = 0;
      for (std::size_t k = c.size(); k-- > 0;) sum = sum * at + static_cast<Long>(c[k]);
      return sum;
    };
    for (std::size_t k = 0; k < count; ++k) {
      const auto& [low, high] = brackets[k];
      EXPECT_TRUE(low <= t[k] && t[k] <= high);
      EXPECT_GE(low, k == 0 ? -1 : brackets[k - 1].high);
      EXPECT_LE(high, 1);
      touching += low == high;
      if (low < high) {
        EXPECT_LT(value(low) * value(high), 0);
      }
    }
  }
  EXPECT_GT(touching, 50);
}

TEST(RealRoots, LeadingZerosLowerTheDegree) {
  expect_roots(roots_of({-0.5, 1, 0, 0}, -1, 1), {0.5}, 1e-16);
  expect_roots(roots_of({-0.5, 0, 0}, -1, 1), {}, 0);
  expect_roots(roots_of({0, 0}, -1, 1), {}, 0);
  expect_roots(roots_of({}, -1, 1), {}, 0);
}

TEST(RealRoots, OfNanAreNone) {
  const double nan = std::nan("");
  for (std::size_t i = 0; i < 4; ++i) {
    std::vector<double> c{-0.5, 1, 2, 3};
    c[i] = nan;
    expect_roots(roots_of(c, -1, 1), {}, 0);
  }
}

// Chebyshev's polynomial of degree n has the roots cos((2k - 1) pi / 2n); by its recurrence
// T_n+1 = 2 t T_n - T_n-1 its coefficients are integers, exact in double up to degree 40.
TEST(RealRoots, OfChebyshevsPolynomials) {
  std::vector<double> before{1}, last{0, 1};
  for (int n = 1; n <= 20; ++n) {
    std::vector<double> expected;
    for (int k = n; k >= 1; --k)
      expected.push_back(std::cos((2 * k - 1) * std::acos(-1.0) / 2 / n));
    expect_roots(roots_of(last, -1.1, 1.1), expected, 1e-16 * std::pow(2.5, n) + 1e-15);
    std::vector<double> next(last.size() + 1, 0);
    for (std::size_t i = 0; i < last.size(); ++i) next[i + 1] = 2 * last[i];
    for (std::size_t i = 0; i < before.size(); ++i) next[i] -= before[i];
    before = last;
    last = next;
  }
}

}  // namespace
}  // namespace tia
