#include "core/shapes/simple/capsule.h"

#include "core/shapes/simple/sphere.h"
#include "tests/core/shapes/lines.h"

namespace tia {
namespace {

using namespace test;

// The distance from the segment, less the radius.
Long outside(const Capsule& c, const Vec3l& p) {
  const auto base = static_cast<Vec3l>(c.base), axis = static_cast<Vec3l>(c.cap) - base;
  const Long square = dot(axis, axis);
  const Long share = square == 0 ? 0 : std::clamp(dot(p - base, axis) / square, Long{0}, Long{1});
  const Vec3l away = p - base - axis * share;
  return std::sqrt(dot(away, away)) - static_cast<Long>(c.radius);
}

TEST(Capsule, PairsNormalsAndUvHoldOnRandomLines) {
  Random random(90);
  int seen = 0;
  for (const double scale : scales) {
    for (int i = 0; i < 80; ++i) {
      const Vec3d base = random.point(3) * scale;
      const Vec3d axis = random.vector(0, random.chance(0.2) ? 1e-9 : 4) * scale;
      const Capsule capsule{base, base + axis, random.in(0.05, 2) * scale};
      const Vec3d middle = (capsule.base + capsule.cap) * 0.5;
      seen += expect_solid(
          prepare(capsule), [&](const Vec3l& p) { return outside(capsule, p); }, middle,
          length(axis) / 2 + capsule.radius, random);
    }
  }
  EXPECT_GT(seen, 3000);
}

// From -2 to 2 along x with radius 1: in the section z = 0 two half circles and two straight sides.
TEST(Capsule, LinesOfItsSymmetryMeetSidesAndCaps) {
  for (const double scale : scales) {
    const CapsuleForm form = prepare(Capsule{{-2 * scale, 0, 0}, {2 * scale, 0, 0}, scale});
    const double far = 8 * scale, near = 1e-14 * scale;
    expect_distances(roots_along(form, {{-far, 0, 0}, {1, 0, 0}}),
                     {far - 3 * scale, far + 3 * scale}, near, "the axis");
    expect_distances(roots_along(form, {{0.5 * scale, far, 0}, {0, -1, 0}}),
                     {far - scale, far + scale}, near, "across the side");
    expect_distances(roots_along(form, {{2.6 * scale, far, 0}, {0, -1, 0}}),
                     {far - 0.8 * scale, far + 0.8 * scale}, near, "3-4-5 through a cap");
    expect_distances(roots_along(form, {{0, 0.6 * scale, 0}, {1, 0, 0}}),
                     {-2.8 * scale, 2.8 * scale}, near, "along the axis, from inside");
    expect_distances(roots_along(form, {{0, 1.001 * scale, 0}, {1, 0, 0}}), {}, 0, "beside it");
    expect_distances(roots_along(form, {{3.001 * scale, far, 0}, {0, -1, 0}}), {}, 0, "beyond it");
  }
}

TEST(Capsule, ElementsTellTheSideFromTheCaps) {
  const CapsuleForm form = prepare(Capsule{{0, 0, 0}, {0, 4, 0}, 1});
  const auto elements = [&](const SceneLine& line) {
    std::vector<int> all;
    for (const Crossing& each : crossings_along(form, line)) all.push_back(each.element);
    return all;
  };
  EXPECT_EQ(elements({{0, -9, 0}, {0, 1, 0}}),
            (std::vector<int>{CapsuleForm::base_ball, CapsuleForm::cap_ball}));
  EXPECT_EQ(elements({{-9, 2, 0}, {1, 0, 0}}),
            (std::vector<int>{CapsuleForm::side, CapsuleForm::side}));
  EXPECT_EQ(elements({{-9, 4.5, 0}, {1, 0, 0}}),
            (std::vector<int>{CapsuleForm::cap_ball, CapsuleForm::cap_ball}));
}

TEST(Capsule, OfNoLengthIsABall) {
  Random random(91);
  for (int i = 0; i < 200; ++i) {
    const Vec3d center = random.point(2);
    const double radius = random.in(0.1, 2);
    const SceneLine line = line_near(random, center, radius);
    EXPECT_EQ(roots_along(prepare(Capsule{center, center, radius}), line),
              roots_along(Sphere{center, radius}, line));
  }
}

// The way from pole to pole: a quarter circle of pi r / 2, the side, a quarter circle.
TEST(Capsule, UvSharesTheWayFromPoleToPole) {
  const CapsuleForm form = prepare(Capsule{{0, 0, 0}, {0, 0, 3}, 1});
  const double quarter = 3.14159265358979 / 2, whole = 2 * quarter + 3;
  EXPECT_NEAR(uv(form, {0, 0, -1}, CapsuleForm::base_ball).v, 0, 1e-15);
  EXPECT_NEAR(uv(form, {1, 0, 0}, CapsuleForm::base_ball).v, quarter / whole, 1e-14);
  EXPECT_NEAR(uv(form, {1, 0, 0}, CapsuleForm::side).v, quarter / whole, 1e-14);
  EXPECT_NEAR(uv(form, {1, 0, 1.5}, CapsuleForm::side).v, 0.5, 1e-15);
  EXPECT_NEAR(uv(form, {0, 0, 4}, CapsuleForm::cap_ball).v, 1, 1e-15);
}

TEST(Capsule, BoundsTouchBothBalls) {
  const Aabb box = bounds(prepare(Capsule{{1, 5, 0}, {4, 2, 0}, 0.5}));
  EXPECT_EQ(box.min, (Vec3d{0.5, 1.5, -0.5}));
  EXPECT_EQ(box.max, (Vec3d{4.5, 5.5, 0.5}));
}

TEST(Capsule, LongOnesKeepTheirDigits) {
  // A line across at a slant of a rod a million times as long as thick.
  const CapsuleForm form = prepare(Capsule{{-1e6, 0, 0}, {1e6, 0, 0}, 1});
  for (const double x : {-999'999.0, -5e5, 0.0, 7e5})
    expect_distances(roots_along(form, {{x, 5, 0}, {0, -1, 0}}), {4, 6}, 1e-12);
}

TEST(Capsule, NaNAndLinesWithoutDirectionCrossNothing) {
  expect_nothing_from_nan(prepare(Capsule{{0, 0, 0}, {0, 1, 0}, 1}));
}

TEST(Capsule, FaultsNameTheirPlace) {
  expect_faults(faults_in<Capsule>(R"({"base":[0,0,0],"cap":[0,1,0],"radius":0})"),
                {{FaultKind::out_of_range, "/radius", "0", "above 0"}});
  expect_faults(faults_in<Capsule>(R"({"base":[0,0,0],"radius":1})"),
                {{FaultKind::missing, "/cap", "", "3 numbers"}});
}

}  // namespace
}  // namespace tia
