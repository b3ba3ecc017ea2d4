#include "core/shapes/algebraic/quadric.h"

#include "tests/core/shapes/lines.h"

namespace tia {
namespace {

using enum FaultKind;
using namespace test;
using Ten = std::array<double, 10>;

// x2 y2 z2 xy xz yz x y z 1
constexpr Ten unit_ball{1, 1, 1, 0, 0, 0, 0, 0, 0, -1};
constexpr Ten pipe{1, 0, 1, 0, 0, 0, 0, 0, 0, -1};        // around y
constexpr Ten hourglass{1, -1, 1, 0, 0, 0, 0, 0, 0, -1};  // hyperboloid of one sheet around y
constexpr Ten two_bowls{1, -1, 1, 0, 0, 0, 0, 0, 0, 1};   // of two sheets, y beyond 1
constexpr Ten double_cone{1, -1, 1, 0, 0, 0, 0, 0, 0, 0};
constexpr Ten bowl{1, 0, 1, 0, 0, 0, 0, -1, 0, 0};        // paraboloid y = x2 + z2
constexpr Ten half_space{0, 0, 0, 0, 0, 0, 0, 2, 0, -2};  // y < 1
constexpr Ten saddle{0, 0, 0, 1, 0, 0, 0, 0, -1, 0};      // z = x y

Long quadric_at(const Ten& k, const Vec3l& p) {
  const Long terms[] = {p.x * p.x, p.y * p.y, p.z * p.z, p.x * p.y, p.x * p.z,
                        p.y * p.z, p.x,       p.y,       p.z,       1};
  Long sum = 0;
  for (std::size_t i = 0; i < 10; ++i) sum += static_cast<Long>(k[i]) * terms[i];
  return sum;
}
// Scaled so that it is a distance near the surface: the sum over its steepness.
struct QuadricDistance {
  Ten k;
  Long size;
  Long operator()(const Vec3l& p) const {
    const Long h = size * 1e-6L;
    const Vec3l slope{quadric_at(k, p + Vec3l{h, 0, 0}) - quadric_at(k, p - Vec3l{h, 0, 0}),
                      quadric_at(k, p + Vec3l{0, h, 0}) - quadric_at(k, p - Vec3l{0, h, 0}),
                      quadric_at(k, p + Vec3l{0, 0, h}) - quadric_at(k, p - Vec3l{0, 0, h})};
    return quadric_at(k, p) / (std::sqrt(dot(slope, slope)) / (2 * h));
  }
};
// The surface grown by a factor: f(p / s) times s^2.
Ten grown_quadric(Ten k, double s) {
  for (std::size_t i = 6; i < 9; ++i) k[i] *= s;
  k[9] *= s * s;
  return k;
}
QuadricForm quadric_form(const Ten& k) { return prepare(Quadric{k, {}}); }
QuadricForm clipped(const Ten& k, const Vec3d& min, const Vec3d& max) {
  Bounds bounds;
  bounds.min = min;
  bounds.max = max;
  return prepare(Quadric{k, bounds});
}

TEST(Quadric, PairsAndNormalsOfEveryClassHoldOnRandomLines) {
  Random random(90);
  int seen = 0;
  for (const double scale : scales)
    for (const Ten& k : {unit_ball, pipe, hourglass, two_bowls, bowl, half_space, saddle})
      for (int i = 0; i < 5; ++i)
        seen += expect_solid(quadric_form(grown_quadric(k, scale)),
                             QuadricDistance{grown_quadric(k, scale), scale}, {0, 0, 0}, 3 * scale,
                             random, false);
  EXPECT_GT(seen, 2000);
}

TEST(Quadric, PairsAndNormalsHoldForRandomCoefficients) {
  Random random(91);
  int seen = 0;
  for (const double scale : scales) {
    for (int i = 0; i < 30; ++i) {
      Ten k{};
      for (double& each : k) each = random.in(-1, 1);
      seen += expect_solid(quadric_form(grown_quadric(k, scale)),
                           QuadricDistance{grown_quadric(k, scale), scale}, {0, 0, 0}, 3 * scale,
                           random, false);
    }
  }
  EXPECT_GT(seen, 1500);
}

TEST(Quadric, BallIsMetLikeASphere) {
  Random random(92);
  for (const double scale : scales) {
    const QuadricForm ball = quadric_form(grown_quadric(unit_ball, scale));
    for (int i = 0; i < 500; ++i) {
      const SceneLine line = line_near(random, {0, 0, 0}, scale);
      const std::vector<double> as_sphere = roots_along(Sphere{{0, 0, 0}, scale}, line);
      expect_distances(roots_along(ball, line), as_sphere, 1e-9 * scale / length(line.direction));
    }
    expect_distances(roots_along(ball, {{-3 * scale, scale, 0}, {1, 0, 0}}), {3 * scale, 3 * scale},
                     1e-7 * scale, "grazing");
  }
}

// Between the sheets lies the outside: x2 + 1 < y2 on the line along y at x is |y| > sqrt(x2 + 1).
TEST(Quadric, InsideMayReachBothEndsOfALine) {
  for (const double s : scales) {
    const QuadricForm bowls = quadric_form(grown_quadric(two_bowls, s));
    const double y = s * std::sqrt(1.25), near = 1e-15 * s;
    expect_distances(roots_along(bowls, {{0.5 * s, 0, 0}, {0, 1, 0}}),
                     {-Aabb::far, -y, y, Aabb::far}, near);
    const QuadricForm waist = quadric_form(grown_quadric(hourglass, s));
    expect_distances(roots_along(waist, {{0.5 * s, 0, 0}, {0, 1, 0}}), {-Aabb::far, Aabb::far}, 0);
    expect_distances(roots_along(waist, {{0, 0, 0}, {1, 0, 0}}), {-s, s}, near);
    const double out = s * std::sqrt(1.25);  // at x = 1.5: y2 > 1.25
    expect_distances(roots_along(waist, {{1.5 * s, 0, 0}, {0, 1, 0}}),
                     {-Aabb::far, -out, out, Aabb::far}, near);
  }
}

TEST(Quadric, LinearAndConstantAlongALineAreMetOnceOrNever) {
  for (const double s : scales) {
    const QuadricForm below = quadric_form(grown_quadric(half_space, s));
    expect_distances(roots_along(below, {{0, 5 * s, 0}, {0, -2, 0}}), {2 * s, Aabb::far},
                     1e-15 * s);
    expect_distances(roots_along(below, {{0, 5 * s, 0}, {0, 2, 0}}), {-Aabb::far, -2 * s},
                     1e-15 * s);
    expect_distances(roots_along(below, {{0, 0, 0}, {1, 0, 0}}), {-Aabb::far, Aabb::far}, 0);
    expect_distances(roots_along(below, {{0, 2 * s, 0}, {1, 0, 0}}), {}, 0);
    // The paraboloid along its axis: in at y = x2, never out.
    const QuadricForm cup = quadric_form(grown_quadric(bowl, s));
    expect_distances(roots_along(cup, {{0.5 * s, -s, 0}, {0, 1, 0}}), {1.25 * s, Aabb::far},
                     1e-15 * s);
  }
}

// Along a pipe, however it is turned, rounding must not make a second root 1e16 away.
TEST(Quadric, LineAlongAPipeMeetsNothingFarAway) {
  Random random(93);
  for (int i = 0; i < 500; ++i) {
    const Vec3d n = random.direction();  // the pipe around n: p.p - (n.p)^2 - 1
    // Where 1 - n.x^2 has lost digits, the coefficients are another surface's.
    if (std::max({std::fabs(n.x), std::fabs(n.y), std::fabs(n.z)}) > 0.9) continue;
    const QuadricForm turned =
        quadric_form({1 - n.x * n.x, 1 - n.y * n.y, 1 - n.z * n.z, -2 * n.x * n.y, -2 * n.x * n.z,
                      -2 * n.y * n.z, 0, 0, 0, -1});
    const Vec3d aside = normalize(cross(n, random.direction()));
    expect_distances(roots_along(turned, {aside * 0.5, n}), {-Aabb::far, Aabb::far}, 0);
    expect_distances(roots_along(turned, {aside * 1.5, n}), {}, 0);
    expect_distances(roots_along(turned, {aside * -3.0, aside}), {2, 4}, 1e-13);
  }
}

TEST(Quadric, CrossesNothingOfNan) {
  expect_nothing_from_nan(quadric_form(unit_ball));
  expect_nothing_from_nan(quadric_form(two_bowls));
  expect_nothing_from_nan(quadric_form(half_space));
  expect_nothing_from_nan(clipped(half_space, {-2, -2, -2}, {2, 2, 2}));
}

// The pipe |y| < 2: a line through its open end meets the wall once, as a solid the end too.
TEST(Quadric, BoundsCutTheSurfaceOpenAndCloseTheSolid) {
  for (const double s : scales) {
    const Vec3d corner = Vec3d{2, 2, 2} * s;
    const QuadricForm form = clipped(grown_quadric(pipe, s), -corner, corner);
    const double near = 1e-14 * s;
    const SceneLine through_end{Vec3d{0, 3, 0} * s, {0.5, -1, 0}};  // leaves at x = 1, y = 1
    expect_distances(roots_along(form, through_end), {2 * s}, near);
    const std::vector<Crossing> solid = spans_along(form, through_end);
    ASSERT_EQ(solid.size(), 2u);
    EXPECT_NEAR(solid[0].t, s, near);
    EXPECT_EQ(solid[0].element, 1 + 3) << "the box's face +y";
    EXPECT_NEAR(solid[1].t, 2 * s, near);
    EXPECT_EQ(solid[1].element, 0);

    const SceneLine axis{Vec3d{0, 3, 0} * s, {0, -1, 0}};
    EXPECT_TRUE(roots_along(form, axis).empty());
    ASSERT_EQ(spans_along(form, axis).size(), 2u);
    EXPECT_EQ(spans_along(form, axis)[1].element, 1 + 2);
    EXPECT_TRUE(roots_along(form, {Vec3d{-3, 2.5, 0} * s, {1, 0, 0}}).empty()) << "beyond the end";
    EXPECT_TRUE(spans_along(form, {Vec3d{-3, 2.5, 0} * s, {1, 0, 0}}).empty());
  }
}

// Two spans of one line, each closed by the bounds at its far end.
TEST(Quadric, ClippedSolidKeepsItsSpansApart) {
  const QuadricForm form = clipped(two_bowls, {-3, -3, -3}, {3, 3, 3});
  const double y = std::sqrt(1.25);
  const std::vector<Crossing> solid = spans_along(form, {{0.5, 0, 0}, {0, 1, 0}});
  ASSERT_EQ(solid.size(), 4u);
  const Crossing expected[] = {{-3, 1 + 2}, {-y, 0}, {y, 0}, {3, 1 + 3}};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(solid[i].t, expected[i].t, 1e-15);
    EXPECT_EQ(solid[i].element, expected[i].element);
  }
}

TEST(Quadric, ClippedSolidIsTheInsideWithinTheBounds) {
  Random random(94);
  int seen = 0;
  for (const double s : scales) {
    for (const Ten& k : {unit_ball, pipe, hourglass, two_bowls, double_cone, bowl, saddle}) {
      Bounds bounds;
      bounds.center = Vec3d{0.3, 0.2, 0.1} * s;
      bounds.radius = 2 * s;
      const QuadricForm form = prepare(Quadric{grown_quadric(k, s), bounds});
      const auto beyond = [&](const Vec3l& p) {
        const auto w = p - static_cast<Vec3l>(*bounds.center);
        return std::sqrt(dot(w, w)) - static_cast<Long>(*bounds.radius);
      };
      const QuadricDistance outside{grown_quadric(k, s), static_cast<Long>(s)};
      for (int i = 0; i < 30; ++i) {
        const SceneLine line = line_near(random, *bounds.center, 2 * s);
        expect_pairs_hold(
            spans_along(form, line),
            [&](const Vec3l& p) { return std::max(outside(p), beyond(p)); }, line, *bounds.center,
            2 * s);
        std::vector<double> within;  // the unclipped roots that the bounds hold
        for (const double t : roots_along(quadric_form(grown_quadric(k, s)), line))
          if (std::isfinite(t) && beyond(line.at(static_cast<Long>(t))) < 0) within.push_back(t);
        expect_distances(roots_along(form, line), within, 1e-8 * s / length(line.direction));
        seen += static_cast<int>(within.size());
        for (const Crossing& each : crossings_along(form, line)) EXPECT_EQ(each.element, 0);
      }
    }
  }
  EXPECT_GT(seen, 500);
}

TEST(Quadric, ElementsNormalsAndUvFollowTheBounds) {
  EXPECT_EQ(elements(quadric_form(pipe)), 1);
  EXPECT_EQ(bounds(quadric_form(pipe)), Aabb::everything());
  const QuadricForm form = clipped(pipe, {-2, -3, -2}, {2, 5, 2});
  EXPECT_EQ(elements(form), 7);
  EXPECT_EQ(bounds(form), (Aabb{{-2, -3, -2}, {2, 5, 2}}));
  EXPECT_EQ(normal(form, {0, 5, 0}, 1 + 3), (Vec3d{0, 1, 0}));
  EXPECT_EQ(normal(quadric_form(double_cone), {0, 0, 0}, 0), (Vec3d{0, 1, 0})) << "at a tip: some";
  EXPECT_EQ(uv(form, {1, 5, 0}, 1 + 3), (Vec2d{0.5, 0.75})) << "as the box has it: along z, x";
  EXPECT_EQ(uv(form, {1, 1, 0}, 0), (Vec2d{0.25, 0.5})) << "longitude, latitude from the middle";
}

TEST(Quadric, WithoutASurfaceIsRefused) {
  expect_faults(faults_in<Quadric>(R"({"coefficients":[0,0,0,0,0,0,0,0,0,5]})"),
                {{out_of_range, "/coefficients", "[0,0,0,0,0,0,0,0,0,5]", "more than a constant"}});
  expect_faults(faults_in<Quadric>(R"({"coefficients":[1,2,3]})"),
                {{FaultKind::wrong_type, "/coefficients", "[1,2,3]", "10 numbers"}});
  expect_faults(
      faults_in<Quadric>(R"({"coefficients":[1,1,1,0,0,0,0,0,0,-1],"bounds":{"min":[0,0,0]}})"),
      {{FaultKind::missing, "/bounds/max", "", "min and max"}});
  expect_faults(faults_in<Quadric>("{}"), {{FaultKind::missing, "/coefficients", "", "x2"}});
}

TEST(Quadric, IsWrittenAsItWasRead) {
  const char* json =
      R"({"bounds":{"center":[0,0,0],"radius":2},"coefficients":[1,0,1,0,0,0,0,0,0,-1]})";
  EXPECT_EQ(to_json(write_value(read_described<Quadric>(parse_json(json)))), json);
}

TEST(Quadric, OneFactorOnAllCoefficientsChangesNoCrossing) {
  const Quadric ball{{1, 1, 1, 0, 0, 0, 0, 0, 0, -1}, {}};
  for (const double factor : {1e-300, 1e-160, 1e-30, 1e30}) {
    Quadric scaled = ball;
    for (double& c : scaled.coefficients) c *= factor;
    std::vector<double> t;
    crossings(prepare(scaled), Line{{0, 0, 0}, {0, -1, 0}},
              [&](double at, int) { t.push_back(at); });
    ASSERT_EQ(t.size(), 2U) << factor;
    EXPECT_NEAR(t[0], -1, 1e-15) << factor;
    EXPECT_NEAR(t[1], 1, 1e-15) << factor;
  }
}

}  // namespace
}  // namespace tia
