// Explicit surfaces: graphs that other kinds give too.
#include "core/shapes/formula/explicit.h"

#include "core/shapes/algebraic/algebraic.h"
#include "core/shapes/algebraic/quadric.h"
#include "tests/core/shapes/isosurfaces.h"

namespace tia {
namespace {

using namespace test;

IsosurfaceForm graph(const std::string& z, const Bounds& bounds,
                     const Parameters& parameters = {}) {
  return prepare(Explicit{z, bounds, parameters});
}

TEST(Explicit, ParaboloidIsTheImplicitTheAlgebraicAndTheQuadric) {
  Random random(1);
  int roots = 0;
  for (int i = 0; i < 10; ++i) {
    const double a = random.in(-2, 2), b = random.in(-2, 2), c = random.in(-1, 1);
    const Parameters all{{"a", a}, {"b", b}, {"c", c}};
    const Bounds bounds = random.chance(0.5) ? cube_of(2) : ball_of(2.5);
    const auto own = graph("a*x^2+b*y^2+c", bounds, all);
    const auto field = implicit("z-a*x^2-b*y^2-c", bounds, all);
    const auto quadric = prepare(Quadric{{-a, -b, 0, 0, 0, 0, 0, 0, 1, -c}, bounds});
    const auto algebraic = prepare(
        Algebraic{{{{2, 0, 0}, -a}, {{0, 2, 0}, -b}, {{0, 0, 1}, 1}, {{0, 0, 0}, -c}}, bounds});
    for (int k = 0; k < 100; ++k) {
      const SceneLine line = line_near(random, {}, 2);
      const auto expected = roots_along(quadric, line);
      const double tolerance = 1e-9 / length(line.direction);
      // Roots that nearly meet are known to half the digits.
      if (expected.size() == 2 && expected[1] - expected[0] < 1e5 * tolerance) continue;
      expect_distances(roots_along(own, line), expected, tolerance);
      expect_distances(roots_along(field, line), expected, tolerance);
      expect_distances(roots_along(algebraic, line), expected, tolerance);
      expect_distances(ends_of(spans_along(own, line)), ends_of(spans_along(field, line)),
                       tolerance);
      roots += static_cast<int>(expected.size());
    }
  }
  EXPECT_GT(roots, 500);
}

TEST(Explicit, LineFromAboveMeetsTheGraphOnceAndGoesInside) {
  Random random(2);
  const auto form = graph("sin(3*x)*cos(2*y)+0.2*floor(x)", cube_of(2));
  for (int i = 0; i < 500; ++i) {
    const double x = random.in(-2, 2), y = random.in(-2, 2);
    const double z = std::sin(3 * x) * std::cos(2 * y) + 0.2 * std::floor(x);
    const SceneLine down{{x, y, 7}, {0, 0, -1}};
    expect_distances(roots_along(form, down), {7 - z}, 1e-9);
    expect_distances(ends_of(spans_along(form, down)), {7 - z, 9}, 1e-9);
    EXPECT_GT(normal(form, {x, y, z}, 0).z, 0);
  }
}

TEST(Explicit, IsOnlyWhereItsFormulaIs) {
  const auto form = graph("sqrt(x)", cube_of(2));
  expect_distances(roots_along(form, {{1, 0, 5}, {0, 0, -1}}), {4}, 1e-9);
  EXPECT_TRUE(roots_along(form, {{-1, 0, 5}, {0, 0, -1}}).empty());
  EXPECT_TRUE(spans_along(form, {{-1, 0, 5}, {0, 0, -1}}).empty());
  // Along x at height 1 it is met at 1; from the formula's edge to it the line is above.
  expect_distances(ends_of(spans_along(form, {{-5, 0, 1}, {1, 0, 0}})), {6, 7}, 1e-9);
  expect_distances(ends_of(spans_along(form, {{-5, 0, -1}, {1, 0, 0}})), {5, 7}, 1e-9);
}

TEST(Explicit, PolesAndJumpsAreNoSurface) {
  const auto pole = graph("1/x", cube_of(2));
  expect_distances(roots_along(pole, {{-5, 0, 1}, {1, 0, 0}}), {6}, 1e-9);
  expect_distances(ends_of(spans_along(pole, {{-5, 0, 1}, {1, 0, 0}})), {5, 6}, 1e-9);
  const auto stairs = graph("floor(x)", cube_of(2));
  EXPECT_TRUE(roots_along(stairs, {{-5, 0, 0.5}, {1, 0, 0}}).empty());
  expect_distances(ends_of(spans_along(stairs, {{-5, 0, 0.5}, {1, 0, 0}})), {6, 7}, 1e-9);
}

TEST(Explicit, DoesNotKnowZ) {
  expect_faults(faults_in<Explicit>(R"({"z":"x+z","bounds":{"center":[0,0,0],"radius":1}})"),
                {{FaultKind::unknown_name, "/z", R"("x+z")", "at column 3"}});
}

}  // namespace
}  // namespace tia
