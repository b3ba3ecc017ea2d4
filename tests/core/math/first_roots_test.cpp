#include "core/math/first_roots.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "tests/core/support.h"

namespace tia {
namespace {

using test::Long;
using test::Random;

// The Bernstein coefficients of the product of a s + b, its factors given as their ends (b, a + b):
// what stands before s^j (1 - s)^(n - j), over the binomial coefficient.
std::vector<double> bernstein(const std::vector<std::array<Long, 2>>& factors) {
  std::vector<Long> scaled{1};
  for (const auto& [from, to] : factors) {
    scaled.push_back(0);
    for (std::size_t j = scaled.size(); j-- > 0;)
      scaled[j] = from * scaled[j] + (j > 0 ? to * scaled[j - 1] : 0);
  }
  Long binomial = 1;
  const std::size_t n = factors.size();
  std::vector<double> b;
  for (std::size_t j = 0; j <= n; ++j) {
    b.push_back(static_cast<double>(scaled[j] / binomial));
    binomial *= static_cast<Long>(n - j) / static_cast<Long>(j + 1);
  }
  return b;
}
// s - root, over its size at the ends.
std::array<Long, 2> factor(Long root) {
  const Long size = std::max(std::fabs(root), std::fabs(1 - root));
  return {-root / size, (1 - root) / size};
}

// Eight polynomials of one degree, by their roots; what is not real comes in pairs c +- i d.
struct EightPolynomials {
  std::array<std::vector<double>, 8> roots;
  std::array<std::vector<double>, 8> coefficients;
  std::vector<Octet> b;

  explicit EightPolynomials(std::size_t degree) : b(degree + 1) {}
  void set(std::size_t lane, const std::vector<double>& c, const std::vector<double>& known) {
    coefficients[lane] = c;
    roots[lane] = known;
    std::sort(roots[lane].begin(), roots[lane].end());
    for (std::size_t j = 0; j < b.size(); ++j) {
      std::array<double, 8> each;
      b[j].store_unaligned(each.data());
      each[lane] = c[j];
      b[j] = Octet::load_unaligned(each.data());
    }
  }
  FirstRoots isolated(double noise, unsigned wanted = 0xFF) const {
    std::vector<Octet> spoilt = b;
    return first_roots(spoilt, Octet(noise), wanted);
  }
};

// What is said of a lane is true of its roots. Returns: whether something is said.
bool expect_true(const FirstRoots& found, int i, const std::vector<double>& roots) {
  const auto has = [i](unsigned lanes) { return (lanes >> i & 1) != 0; };
  std::vector<double> within;
  for (const double root : roots)
    if (root > 0 && root < 1) within.push_back(root);
  EXPECT_FALSE(has(found.isolated) && has(found.unsure));
  if (has(found.unsure)) return false;
  if (!has(found.isolated)) {
    EXPECT_TRUE(within.empty()) << within.front();
    return true;
  }
  const double from = lane(found.from, i), to = lane(found.to, i), guess = lane(found.guess, i);
  EXPECT_LE(from, guess);
  EXPECT_LE(guess, to);
  EXPECT_FALSE(within.empty());
  if (within.empty()) return true;
  EXPECT_LT(from, within[0]);
  EXPECT_GT(to, within[0]);
  if (within.size() > 1) {
    EXPECT_LE(to, within[1]);
  }
  return true;
}

TEST(FirstRoots, AreIsolatedWhereverTheRootsAreApart) {
  Random random(70);
  int isolated = 0, none = 0, unsure = 0;
  for (int round = 0; round < 3000; ++round) {
    const auto degree = static_cast<std::size_t>(random.whole(1, 10));
    EightPolynomials eight(degree);
    for (std::size_t i = 0; i < 8; ++i) {
      std::vector<std::array<Long, 2>> factors;
      std::vector<double> roots;
      for (std::size_t k = 0; k < degree; ++k) {
        roots.push_back(random.in(-1, 2));
        factors.push_back(factor(static_cast<Long>(roots.back())));
      }
      eight.set(i, bernstein(factors), roots);
    }
    const FirstRoots found = eight.isolated(1e-15);
    for (int i = 0; i < 8; ++i) {
      const auto at = static_cast<std::size_t>(i);
      if (!expect_true(found, i, eight.roots[at])) {
        ++unsure;
        continue;
      }
      const bool one = (found.isolated >> i & 1) != 0;
      (one ? isolated : none) += 1;
      if (one) {
        EXPECT_EQ((found.falls >> i & 1) != 0, eight.coefficients[at][0] > 0);
      }
    }
  }
  EXPECT_GT(isolated, 12000);
  EXPECT_GT(none, 2000);
  EXPECT_LT(unsure, 24);
}

// A pair of complex roots changes no sign; a double root cannot be told from a near miss, but no
// root before it is lost.
TEST(FirstRoots, LeaveOpenWhatRoundingLeavesOpen) {
  Random random(71);
  int unsure = 0, missed = 0;
  for (int round = 0; round < 2000; ++round) {
    EightPolynomials eight(4);
    for (std::size_t i = 0; i < 8; ++i) {
      const double touching = random.in(0.05, 0.95), root = random.in(-1, 2);
      const auto twice = factor(static_cast<Long>(touching));
      eight.set(i, bernstein({twice, twice, factor(static_cast<Long>(root)), {1, 1}}),
                {touching, touching, root});
    }
    const FirstRoots found = eight.isolated(1e-14);
    for (int i = 0; i < 8; ++i) {
      const auto& roots = eight.roots[static_cast<std::size_t>(i)];
      const double first = roots[0] > 0 ? roots[0] : roots[1];
      const bool single_first = first < 1 && first != roots[1] && first > 0 && roots[0] > 0;
      const bool open = (found.unsure >> i & 1) != 0;
      unsure += open;
      if (single_first) {
        missed += !expect_true(found, i, {first});
      } else {
        EXPECT_TRUE(open) << first;
      }
    }
  }
  EXPECT_GT(unsure, 8000);
  EXPECT_LT(missed, 20);
}

TEST(FirstRoots, OfPairsThatAreNotRealThereAreNone) {
  Random random(72);
  for (int round = 0; round < 2000; ++round) {
    // ((s - c)^2 + d^2)^2 in Bernstein's form: its quadratic is c^2 + d^2, c^2 + d^2 - c, ...
    EightPolynomials eight(2);
    for (std::size_t i = 0; i < 8; ++i) {
      const double c = random.in(-1, 2), d = random.in(0.01, 1), sign = random.chance(0.5) ? 1 : -1;
      const double first = c * c + d * d;
      eight.set(i, {sign * first, sign * (first - c), sign * (first - 2 * c + 1)}, {});
    }
    const FirstRoots found = eight.isolated(1e-15);
    EXPECT_EQ(found.isolated, 0U);
    EXPECT_EQ(found.unsure, 0U);
  }
}

TEST(FirstRoots, DoNotDependOnTheirNeighbours) {
  Random random(73);
  for (int round = 0; round < 500; ++round) {
    EightPolynomials eight(6);
    for (std::size_t i = 0; i < 8; ++i) {
      std::vector<double> c;
      for (int k = 0; k < 7; ++k) c.push_back(random.in(-1, 1));
      eight.set(i, c, {});
    }
    const FirstRoots all = eight.isolated(1e-15);
    for (int i = 0; i < 8; ++i) {
      const unsigned own = 1U << i;
      EightPolynomials alone(6);
      for (std::size_t k = 0; k < 8; ++k)
        alone.set(k, eight.coefficients[static_cast<std::size_t>(i)], {});
      const FirstRoots one = alone.isolated(1e-15, own);
      EXPECT_EQ(one.isolated, all.isolated & own);
      EXPECT_EQ(one.unsure, all.unsure & own);
      EXPECT_EQ(one.falls, all.falls & own);
      if (one.isolated == 0) continue;
      EXPECT_EQ(lane(one.from, i), lane(all.from, i));
      EXPECT_EQ(lane(one.to, i), lane(all.to, i));
      EXPECT_EQ(lane(one.guess, i), lane(all.guess, i));
    }
  }
}

TEST(FirstRoots, OfNoNumberAreUnsureAndOfNobodyNothing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EightPolynomials eight(3);
  for (std::size_t i = 0; i < 8; ++i) eight.set(i, {1, nan, -1, 2}, {});
  const FirstRoots found = eight.isolated(1e-15, 0x0F);
  EXPECT_EQ(found.isolated, 0U);
  EXPECT_EQ(found.unsure, 0x0FU);
  const FirstRoots nobody = eight.isolated(1e-15, 0);
  EXPECT_EQ(nobody.isolated | nobody.unsure, 0U);
}

TEST(FirstRoots, AreFoundUpToTheHighestDegree) {
  EightPolynomials eight(64);
  for (std::size_t i = 0; i < 8; ++i) {
    const Long root = 0.1L + 0.1L * static_cast<Long>(i);
    std::vector<std::array<Long, 2>> factors(63, {1, 1.01L});  // all far outside
    factors.push_back(factor(root));
    eight.set(i, bernstein(factors), {static_cast<double>(root)});
  }
  const FirstRoots found = eight.isolated(1e-13);
  EXPECT_EQ(found.isolated, 0xFFU);
  for (int i = 0; i < 8; ++i) expect_true(found, i, eight.roots[static_cast<std::size_t>(i)]);
}

}  // namespace
}  // namespace tia
