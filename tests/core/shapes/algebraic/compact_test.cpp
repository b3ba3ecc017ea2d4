#include "core/shapes/algebraic/compact.h"

#include <gtest/gtest.h>

#include "core/shapes/algebraic/algebraic.h"
#include "tests/core/support.h"

namespace tia {
namespace {

using test::Random;

// ((x - c.x)^2 + ...)^2 expands to many terms; these are built of them as lists.
std::vector<AlgebraicTerm> product_of(const std::vector<AlgebraicTerm>& a,
                                      const std::vector<AlgebraicTerm>& b) {
  std::vector<AlgebraicTerm> all;
  for (const AlgebraicTerm& m : a)
    for (const AlgebraicTerm& n : b)
      all.push_back(
          {{m.powers[0] + n.powers[0], m.powers[1] + n.powers[1], m.powers[2] + n.powers[2]},
           m.coefficient * n.coefficient});
  return collected(all);
}
std::vector<AlgebraicTerm> sum(std::vector<AlgebraicTerm> a, const std::vector<AlgebraicTerm>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return collected(a);
}
std::vector<AlgebraicTerm> square_around(const Vec3d& c, const Vec3d& k, double constant) {
  return collected({{{2, 0, 0}, k.x},
                    {{1, 0, 0}, -2 * k.x * c.x},
                    {{0, 2, 0}, k.y},
                    {{0, 1, 0}, -2 * k.y * c.y},
                    {{0, 0, 2}, k.z},
                    {{0, 0, 1}, -2 * k.z * c.z},
                    {{0, 0, 0}, k.x * c.x * c.x + k.y * c.y * c.y + k.z * c.z * c.z + constant}});
}
void expect_around(const std::optional<Box>& box, const Vec3d& low, const Vec3d& high) {
  ASSERT_TRUE(box);
  const Vec3d room = (high - low) * 0.5;
  const auto near = [](double outer, double inner, double by) {
    EXPECT_LE(outer, inner);
    EXPECT_GE(outer, inner - by);
  };
  near(box->min.x, low.x, room.x), near(-box->max.x, -high.x, room.x);
  near(box->min.y, low.y, room.y), near(-box->max.y, -high.y, room.y);
  near(box->min.z, low.z, room.z), near(-box->max.z, -high.z, room.z);
}

TEST(CompactBounds, HoldEllipsoidsClosely) {
  Random random(76);
  for (const double scale : {1e-3, 1.0, 1e3}) {
    for (int i = 0; i < 50; ++i) {
      const Vec3d center = random.vector(0.1, 1) * scale;
      const auto half = [&] { return random.in(0.5, 2) * scale; };
      const Vec3d h{half(), half(), half()};
      const Vec3d k{1 / (h.x * h.x), 1 / (h.y * h.y), 1 / (h.z * h.z)};
      expect_around(compact_bounds(square_around(center, k, -1)), center - h, center + h);
    }
  }
}

// (|p|^2 + R^2 - r^2)^2 = 4 R^2 (x^2 + z^2) reaches to R + r, along y to r.
TEST(CompactBounds, HoldATorusClosely) {
  Random random(77);
  for (int i = 0; i < 20; ++i) {
    const double R = random.in(0.5, 2), r = random.in(0.1, 0.9) * R;
    const auto s = square_around({0, 0, 0}, {1, 1, 1}, R * R - r * r);
    const auto torus = sum(product_of(s, s), {{{2, 0, 0}, -4 * R * R}, {{0, 0, 2}, -4 * R * R}});
    const auto box = compact_bounds(torus);
    ASSERT_TRUE(box);
    EXPECT_GE(box->max.x, R + r);
    EXPECT_GE(box->max.y, r);
    EXPECT_LE(box->max.x, 1.5 * (R + r));
    EXPECT_EQ(box->min, -box->max);
  }
}

TEST(CompactBounds, AreNoneOfWhatReachesFarOut) {
  const auto plane = collected({{{1, 0, 0}, 1}, {{0, 0, 0}, -1}});
  const auto cylinder = collected({{{2, 0, 0}, 1}, {{0, 2, 0}, 1}, {{0, 0, 0}, -1}});
  const auto outside = square_around({0, 0, 0}, {-1, -1, -1}, 1);  // inside beyond the ball
  const auto saddle = square_around({0, 0, 0}, {1, -1, 1}, -1);
  const auto nothing = square_around({0, 0, 0}, {1, 1, 1}, 1);
  for (const auto& terms : {plane, cylinder, outside, saddle, nothing})
    EXPECT_FALSE(compact_bounds(terms));
}

// x^4 + y^4 + z^4 - a (x^2 y^2 + ...) is definite while a < 1: on the diagonal it is 3 - 3 a.
TEST(CompactBounds, AreFoundUpToTheEdgeOfDefiniteness) {
  const auto quartic = [](double a) {
    return collected({{{4, 0, 0}, 1},
                      {{0, 4, 0}, 1},
                      {{0, 0, 4}, 1},
                      {{2, 2, 0}, -a},
                      {{0, 2, 2}, -a},
                      {{2, 0, 2}, -a},
                      {{0, 0, 0}, -1}});
  };
  for (const double a : {-1.0, 0.0, 0.5, 0.75}) EXPECT_TRUE(compact_bounds(quartic(a))) << a;
  for (const double a : {1.0, 1.1, 3.0}) EXPECT_FALSE(compact_bounds(quartic(a))) << a;
}

}  // namespace
}  // namespace tia
