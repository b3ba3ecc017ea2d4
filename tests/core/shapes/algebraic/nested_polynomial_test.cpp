#include "core/shapes/algebraic/nested_polynomial.h"

#include <gtest/gtest.h>

#include "tests/core/support.h"

namespace tia {
namespace {

using test::Long;
using test::Random;

std::vector<AlgebraicTerm> random_terms(Random& random, int degree) {
  std::vector<AlgebraicTerm> terms;
  for (int count = random.whole(1, 20); count > 0; --count) {
    const int i = random.whole(0, degree), j = random.whole(0, degree - i);
    const int k = random.whole(0, degree - i - j);
    terms.push_back({{i, j, k}, random.in(-2, 2)});
  }
  return collected(terms);
}

Long long_power(double base, int exponent) {
  Long product = 1;
  for (int i = 0; i < exponent; ++i) product *= static_cast<Long>(base);
  return product;
}
// One term, or with powers[by] taken down what its derivative by that coordinate is.
Long term_at(const AlgebraicTerm& term, const Vec3d& p, int by) {
  auto n = term.powers;
  Long factor = static_cast<Long>(term.coefficient);
  if (by >= 0) factor *= n[static_cast<std::size_t>(by)]--;
  if (factor == 0) return 0;
  return factor * long_power(p.x, n[0]) * long_power(p.y, n[1]) * long_power(p.z, n[2]);
}
struct Sums {
  Long value = 0, size = 0;
};
Sums sums_at(const std::vector<AlgebraicTerm>& terms, const Vec3d& p, int by = -1) {
  Sums sums;
  for (const AlgebraicTerm& term : terms) {
    const Long each = term_at(term, p, by);
    sums.value += each;
    sums.size += std::fabs(each);
  }
  return sums;
}
void expect_sum(double got, const Sums& expected) {
  EXPECT_NEAR(got, static_cast<double>(expected.value), 1e-14 * static_cast<double>(expected.size));
}

TEST(NestedPolynomial, IsTheSumOfItsTermsWithItsGradient) {
  Random random(74);
  for (int i = 0; i < 2000; ++i) {
    const std::vector<AlgebraicTerm> terms = random_terms(random, random.whole(0, 12));
    const NestedPolynomial polynomial(terms);
    const Vec3d p = random.vector(0, 2), way = normalize(random.vector(0.1, 1));
    const auto at = polynomial.sum<ValueAndGradient<double>>(p);
    expect_sum(at.value, sums_at(terms, p));
    Sums slope;
    for (int by = 0; by < 3; ++by) {
      const Sums own = sums_at(terms, p, by);
      expect_sum(at.gradient[static_cast<std::size_t>(by)], own);
      slope.value += own.value * static_cast<Long>(by == 0 ? way.x : by == 1 ? way.y : way.z);
      slope.size += own.size;
    }
    const auto along = polynomial.sum<ValueAndSlope<double>>(PointOnLine<double>{p, way});
    EXPECT_EQ(along.value, at.value);
    expect_sum(along.slope, slope);
    const Vec3d sizes{std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)};
    EXPECT_GE(polynomial.sum<Magnitude<double>>(sizes).value,
              static_cast<double>(sums_at(terms, p).size) * (1 - 1e-14));
  }
}

TEST(NestedPolynomial, OfEightPointsIsEachPointsToTheBit) {
  Random random(75);
  for (int i = 0; i < 300; ++i) {
    const NestedPolynomial polynomial(random_terms(random, 8));
    std::array<Vec3d, 8> p;
    std::array<std::array<double, 8>, 3> parts;
    for (std::size_t k = 0; k < 8; ++k) {
      p[k] = random.vector(0, 3);
      parts[0][k] = p[k].x, parts[1][k] = p[k].y, parts[2][k] = p[k].z;
    }
    const auto of = [&](std::size_t k) { return Octet::load_unaligned(parts[k].data()); };
    const auto eight = polynomial.sum<ValueAndGradient<Octet>>(Vec3<Octet>{of(0), of(1), of(2)});
    for (int k = 0; k < 8; ++k) {
      const auto one = polynomial.sum<ValueAndGradient<double>>(p[static_cast<std::size_t>(k)]);
      EXPECT_EQ(lane(eight.value, k), one.value);
      for (std::size_t by = 0; by < 3; ++by)
        EXPECT_EQ(lane(eight.gradient[by], k), one.gradient[by]);
    }
  }
}

TEST(NestedPolynomial, KnowsItsDegreeAndMayBeEmpty) {
  EXPECT_EQ(NestedPolynomial().sum<ValueAndGradient<double>>(Vec3d{1, 2, 3}).value, 0);
  EXPECT_EQ(NestedPolynomial().degree(), 0);
  EXPECT_EQ(NestedPolynomial(collected({{{1, 2, 3}, 4}, {{0, 5, 0}, 1}})).degree(), 6);
  EXPECT_TRUE(collected({{{1, 0, 0}, 2}, {{1, 0, 0}, -2}}).empty());
}

}  // namespace
}  // namespace tia
