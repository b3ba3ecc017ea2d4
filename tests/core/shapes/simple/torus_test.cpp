#include "core/shapes/simple/torus.h"

#include "tests/core/shapes/lines.h"

namespace tia {
namespace {

using enum FaultKind;
using namespace test;

// The distance from the tube's middle circle, less its radius.
Long outside(const Torus& torus, const Vec3l& p) {
  const Long aside = std::sqrt(p.x * p.x + p.z * p.z) - static_cast<Long>(torus.major_radius);
  return std::sqrt(aside * aside + p.y * p.y) - static_cast<Long>(torus.minor_radius);
}

TEST(Torus, PairsNormalsAndUvHoldOnRandomLines) {
  Random random(80);
  int seen = 0;
  for (const double scale : scales) {
    for (int i = 0; i < 80; ++i) {
      const double major = random.in(0.5, 3) * scale;
      const Torus torus{major, major * random.in(0.02, 0.98)};
      seen += expect_solid(
          prepare(torus), [&](const Vec3l& p) { return outside(torus, p); }, {0, 0, 0},
          torus.major_radius + torus.minor_radius, random);
    }
  }
  EXPECT_GT(seen, 3000);
}

// In the section z = 0 the torus is two circles of radius r around x = -R and x = R.
TEST(Torus, LinesOfItsSymmetryMeetItsCircles) {
  for (const double scale : scales) {
    const double r = 0.5 * scale, major = 2 * scale, near = 1e-14 * scale;
    const TorusForm ring = prepare(Torus{major, r});
    const double far = 5 * scale;
    expect_distances(roots_along(ring, {{-far, 0, 0}, {1, 0, 0}}),
                     {far - major - r, far - major + r, far + major - r, far + major + r}, near,
                     "across, from outside");
    expect_distances(roots_along(ring, {{major, 0, 0}, {0, 0.5, 0}}), {-2 * r, 2 * r}, near,
                     "up through the tube, from inside");
    expect_distances(roots_along(ring, {{major + 0.6 * r, -far, 0}, {0, 1, 0}}),
                     {far - 0.8 * r, far + 0.8 * r}, near, "3-4-5 in the tube");
    expect_distances(roots_along(ring, {{0, far, 0}, {0, -1, 0}}), {}, 0, "the axis");
    expect_distances(roots_along(ring, {{0, 0, -far}, {0, 0, 1}}),
                     {far - major - r, far - major + r, far + major - r, far + major + r}, near);
  }
}

// Touched lines, twice each: to the square root of the rounding, for there the slope is 0.
TEST(Torus, GrazingLinesEmitTwice) {
  for (const double scale : scales) {
    const double r = 0.5 * scale, major = 2 * scale, near = 1e-6 * scale;
    const TorusForm ring = prepare(Torus{major, r});
    expect_distances(roots_along(ring, {{0, r, 0}, {1, 0, 0}}), {-major, -major, major, major},
                     near, "the top's circle, at both ends of a diameter");
    // Along z at x = R - r the hole is touched, the rim crossed at z^2 = (R+r)^2 - (R-r)^2 = 4Rr.
    const double z = 2 * std::sqrt(major * r);
    expect_distances(roots_along(ring, {{major - r, 0, 0}, {0, 0, 1}}), {-z, 0, 0, z}, near);
    expect_distances(roots_along(ring, {{major + r, 0, 0}, {0, 0, 1}}), {0, 0}, near, "the rim");
    // Through the middle with the sine r/R: it touches both circles, at sqrt(R^2 - r^2).
    const double sine = r / major, cosine = std::sqrt(1 - sine * sine), t = major * cosine;
    expect_distances(roots_along(ring, {{0, 0, 0}, {cosine, sine, 0}}), {-t, -t, t, t}, near);
  }
}

TEST(Torus, HitAndMissPartAtTheSurface) {
  const double major = 2, r = 0.5;
  const TorusForm ring = prepare(Torus{major, r});
  for (const double e : {1e-3, 1e-6, 1e-9}) {
    EXPECT_EQ(roots_along(ring, {{0, r * (1 - e), 0}, {1, 0, 0}}).size(), 4u) << e;
    EXPECT_EQ(roots_along(ring, {{0, r * (1 + e), 0}, {1, 0, 0}}).size(), 0u) << e;
    EXPECT_EQ(roots_along(ring, {{(major + r) * (1 - e), 0, 0}, {0, 0, 1}}).size(), 2u) << e;
    EXPECT_EQ(roots_along(ring, {{(major + r) * (1 + e), 0, 0}, {0, 0, 1}}).size(), 0u) << e;
    EXPECT_EQ(roots_along(ring, {{(major - r) * (1 + e), 0, 0}, {0, 0, 1}}).size(), 2u) << e;
    EXPECT_EQ(roots_along(ring, {{(major - r) * (1 - e), 0, 0}, {0, 0, 1}}).size(), 4u) << e;
  }
}

// Two tangents that double holds exactly but for their direction within the plane y = r.
TEST(Torus, TopsTangentsTouchWhicheverWayTheyRun) {
  Random random(81);
  for (int i = 0; i < 200; ++i) {
    const double major = random.in(1, 3), r = major * random.in(0.1, 0.9), angle = random.in(0, 6);
    const TorusForm ring = prepare(Torus{major, r});
    const Vec3d way{std::cos(angle), 0, std::sin(angle)};
    const Vec3d foot = Vec3d{-way.z, 0, way.x} * (0.6 * major) + Vec3d{0, r, 0};
    const double t = 0.8 * major;  // 3-4-5
    expect_distances(roots_along(ring, {foot, way}), {-t, -t, t, t}, 1e-6);
  }
}

// Lines through the tube at 1 to 9 from its surface, at most 0.99 of its radius off its middle.
TEST(Torus, ThinTubeIsMetAndKeepsItsRadius) {
  Random random(82);
  for (const double tube : {1e-2, 1e-4, 1e-6}) {
    const Torus torus{3, 3 * tube};
    const TorusForm ring = prepare(torus);
    for (int i = 0; i < 500; ++i) {
      const double angle = random.in(0, 6.28);
      const Vec3d middle{3 * std::cos(angle), 0, 3 * std::sin(angle)};
      const Vec3d target = middle + random.vector(0, 0.99 * torus.minor_radius);
      const Vec3d way = random.vector(1, 9);
      const SceneLine line{target - way, way};
      const std::vector<double> roots = roots_along(ring, line);
      ASSERT_GE(roots.size(), 2u) << tube;
      for (const double t : roots)
        EXPECT_LT(std::fabs(outside(torus, line.at(static_cast<Long>(t)))), 1e-11);
    }
  }
}

TEST(Torus, CrossesNothingOfNan) { expect_nothing_from_nan(prepare(Torus{1, 0.5})); }

TEST(Torus, UvTurnAroundTheAxisAndAroundTheTube) {
  const TorusForm ring = prepare(Torus{2, 0.5});
  EXPECT_EQ(uv(ring, {0, 0, 2.5}, 0), (Vec2d{0, 0}));
  EXPECT_EQ(uv(ring, {2, 0.5, 0}, 0), (Vec2d{0.25, 0.25}));
  EXPECT_EQ(uv(ring, {0, 0, -1.5}, 0), (Vec2d{0.5, 0.5}));
  EXPECT_EQ(uv(ring, {-2, -0.5, 0}, 0), (Vec2d{0.75, 0.75}));
}

TEST(Torus, WithoutAHoleIsRefused) {
  expect_faults(faults_in<Torus>(R"({"major_radius":1,"minor_radius":1})"),
                {{out_of_range, "/minor_radius", "1", "below major_radius"}});
  expect_faults(faults_in<Torus>(R"({"major_radius":0,"minor_radius":-1})"),
                {{out_of_range, "/major_radius", "0", "above 0"},
                 {out_of_range, "/minor_radius", "-1", "above 0"}});
  EXPECT_TRUE(faults_in<Torus>(R"({"major_radius":1,"minor_radius":0.999})").empty());
}

}  // namespace
}  // namespace tia
