// Parametric surfaces that are hardly surfaces: curves, points, undefined parts, poles; and what of
// a description is refused.
#include "core/math/deterministic.h"
#include "core/shapes/parametric/parametric.h"
#include "tests/core/shapes/lines.h"

namespace tia {
namespace {

using namespace test;

constexpr std::array<double, 2> unit_range{0, 1}, both{-1, 1};

TEST(ParametricEdges, CurvesAndPointsAreBoundedWork) {
  Random random(1);
  const std::vector<Parametric> all{{"u", "0", "0", both, both, {}},
                                    {"0", "0", "0", both, both, {}},
                                    {"u", "u", "u", both, both, {}},
                                    {"0*u", "v^2", "v", both, both, {}},
                                    {"sin(1e5*u)", "cos(1e5*v)", "u*v", both, both, {}},
                                    {"u/v", "v/u", "1/(u+v)", both, both, {}}};
  for (const Parametric& each : all) {
    const ParametricForm form = prepare(each);
    for (int i = 0; i < rounds(100); ++i) {
      const Vec3d origin = random.vector(2, 4);
      // At the curves, too: along the first axis and at the origin.
      const Vec3d target = i % 3 == 0   ? Vec3d{random.in(-1, 1), 0, 0}
                           : i % 3 == 1 ? Vec3d{0, 0, 0}
                                        : random.point(1);
      const SceneLine line{origin, normalize(target - origin)};
      EXPECT_LT(work_along(form, line), 1'500'000) << each.x;
      for (const Crossing& hit : crossings_along(form, line)) {
        const Vec3d p = line.origin + line.direction * hit.t;
        EXPECT_TRUE(std::isfinite(hit.t)) << each.x;
        EXPECT_NEAR(length(normal(form, p, hit.element)), 1, 1e-12) << each.x;
        const Vec2d place = uv(form, p, hit.element);
        EXPECT_TRUE(place.u >= 0 && place.u <= 1 && place.v >= 0 && place.v <= 1) << each.x;
      }
    }
  }
}

TEST(ParametricEdges, GenericLinesMissCurves) {
  Random random(2);
  const ParametricForm form = prepare(Parametric{"u", "0", "0", both, both, {}});
  for (int i = 0; i < 300; ++i) {
    const Vec3d origin = random.vector(2, 4), target = random.point(1);
    if (target.y * target.y + target.z * target.z < 0.01) continue;
    const Vec3d d = normalize(target - origin);
    // How far the line passes from the axis.
    const Vec3d across = cross(d, Vec3d{1, 0, 0});
    if (std::fabs(dot(origin, normalize(across))) < 1e-3) continue;
    EXPECT_TRUE(crossings_along(form, {origin, d}).empty());
  }
}

TEST(ParametricEdges, WhereAFormulaIsUndefinedThereIsNothing) {
  const ParametricForm form = prepare(Parametric{"sqrt(u)", "v", "u", both, both, {}});
  Random random(3);
  for (int i = 0; i < 300; ++i) {
    const double u = random.in(-1, 1), v = random.in(-1, 1);
    const SceneLine along{{-3, v, u}, {1, 0, 0}};
    expect_distances(roots_along(form, along),
                     u > 0 ? std::vector{3 + std::sqrt(u)} : std::vector<double>{}, 1e-9);
  }
}

TEST(ParametricEdges, PolesLeaveTheRestAsItIs) {
  // Beyond what the smallest patch next to a pole holds there is nothing.
  const ParametricForm form = prepare(Parametric{"u", "v", "tan(u)", {0, pi}, both, {}});
  Random random(4);
  for (int i = 0; i < 300; ++i) {
    const double u = random.in(0, pi), v = random.in(-1, 1);
    if (std::fabs(u - pi / 2) < 0.05) continue;
    const SceneLine down{{u, v, 50}, {0, 0, -1}};
    expect_distances(roots_along(form, down), {50 - std::tan(u)}, 1e-7);
  }
}

TEST(ParametricEdges, EdgesOfTheDomainAreEdgesOfTheSurface) {
  const ParametricForm form = prepare(Parametric{"u", "v", "u*v", unit_range, unit_range, {}});
  for (const double v : {0.0, 0.25, 0.5, 1.0}) {
    expect_distances(roots_along(form, {{1 - 1e-6, v, 3}, {0, 0, -1}}), {3 - v * (1 - 1e-6)}, 1e-9);
    EXPECT_TRUE(roots_along(form, {{1 + 1e-6, v, 3}, {0, 0, -1}}).empty());
    EXPECT_TRUE(roots_along(form, {{-1e-6, v, 3}, {0, 0, -1}}).empty());
    // In the edges themselves.
    EXPECT_EQ(roots_along(form, {{1, v, 3}, {0, 0, -1}}).size(), 1U);
    EXPECT_EQ(roots_along(form, {{v, 0, 3}, {0, 0, -1}}).size(), 1U);
  }
}

TEST(ParametricEdges, TwoOfOneTextAreTheSameToTheBit) {
  const Parametric wave{"u", "sin(3*u*v)", "v", both, both, {}};
  const ParametricForm a = prepare(wave), b = prepare(wave);
  Random random(5);
  for (int i = 0; i < 200; ++i) {
    const SceneLine line = line_near(random, {}, 1);
    EXPECT_EQ(roots_along(a, line), roots_along(b, line));
  }
}

TEST(ParametricEdges, LinesThatHaveNaNCrossNothing) {
  expect_nothing_from_nan(prepare(Parametric{"u", "v", "u*v", both, both, {}}));
}

}  // namespace
}  // namespace tia
