#include "core/shapes/algebraic/blend.h"

#include "tests/core/faults.h"
#include "tests/core/shapes/lines.h"
#include "tests/core/support.h"

namespace tia {
namespace {

using namespace test;

Blended placed(const auto& shape, std::vector<TransformSteps::Step> steps = {}) {
  return {shape, {std::move(steps)}};
}
Blend blend_of(Operation operation, double radius, std::vector<Blended> children) {
  Blend blend;
  blend.operation = operation;
  blend.radius = radius;
  blend.children = std::move(children);
  return blend;
}
std::vector<double> crossings_from(const IsosurfaceForm& form, const Vec3d& from,
                                   const Vec3d& way) {
  const Vec3d d = normalize(way);
  const double shift = dot(bounds(form).center() - from, d);
  std::vector<double> t;
  crossings(form, Line{from + d * shift, d}, [&](double at, int) { t.push_back(at + shift); });
  return t;
}

// Two walls at right angles, x <= 0 and y <= 0: the round is the circle of radius r around (r, r).
TEST(Blend, TwoWallsAtRightAnglesAreJoinedByAQuarterOfACircle) {
  Random random(1);
  for (int i = 0; i < rounds(20); ++i) {
    const double r = random.in(0.05, 1.5);
    const Box floor{{-4, -4, -4}, {0, 4, 4}}, wall{{-4, -4, -4}, {4, 0, 4}};
    const IsosurfaceForm form =
        prepare(blend_of(Operation::union_, r, {placed(floor), placed(wall)}));
    // From the circle's middle towards the corner.
    const double angle = random.in(0.01, pi / 2 - 0.01), z = random.in(-2, 2);
    const Vec3d way{-std::cos(angle), -std::sin(angle), 0};
    const auto t = crossings_from(form, {r, r, z}, way);
    ASSERT_FALSE(t.empty());
    const auto ahead = std::find_if(t.begin(), t.end(), [](double at) { return at > 0; });
    ASSERT_NE(ahead, t.end());
    EXPECT_NEAR(*ahead, r, 1e-12);
    const Vec3d n = normal(form, Vec3d{r, r, z} + way * r, 0);
    EXPECT_NEAR(dot(n, way), -1, 1e-9);
  }
}

// What is left of the block x, y <= 0 has its edge rounded within: the circle around (-r, -r).
TEST(Blend, AnIntersectionRoundsItsEdgeOff) {
  Random random(2);
  for (int i = 0; i < rounds(20); ++i) {
    const double r = random.in(0.05, 1.5);
    const Box floor{{-4, -4, -4}, {0, 4, 4}}, wall{{-4, -4, -4}, {4, 0, 4}};
    const IsosurfaceForm form =
        prepare(blend_of(Operation::intersection, r, {placed(floor), placed(wall)}));
    const double angle = random.in(0.01, pi / 2 - 0.01), z = random.in(-2, 2);
    const Vec3d way{-std::cos(angle), -std::sin(angle), 0};
    const auto t = crossings_from(form, Vec3d{-r, -r, z} - way * 3.0, way);
    ASSERT_FALSE(t.empty());
    EXPECT_NEAR(t.front(), 3 - r, 1e-12);
  }
}

TEST(Blend, FarFromTheOthersAChildIsItself) {
  Random random(3);
  for (int i = 0; i < rounds(12); ++i) {
    const Sphere one{{-3, 0, 0}, random.in(0.3, 1)}, other{{3, 0, 0}, random.in(0.3, 1)};
    const IsosurfaceForm form =
        prepare(blend_of(Operation::union_, random.in(0.1, 1), {placed(one), placed(other)}));
    const Vec3d from = random.vector(6, 9) + Vec3d{-3, 0, 0};
    const Vec3d way = one.center + random.vector(0, 0.9 * one.radius) - from;
    const auto t = crossings_from(form, from, way);
    std::vector<double> expected;
    const Vec3d d = normalize(way);
    crossings(one, Line{from, d}, [&](double at, int) { expected.push_back(at); });
    crossings(other, Line{from, d}, [&](double at, int) { expected.push_back(at); });
    std::sort(expected.begin(), expected.end());
    ASSERT_EQ(t.size(), expected.size());
    for (std::size_t k = 0; k < t.size(); ++k) EXPECT_NEAR(t[k], expected[k], 1e-10);
  }
}

// Ball and ball with a radius of 0: the boundaries are those of csg.
TEST(Blend, WithoutARadiusItIsCsg) {
  Random random(4);
  for (int i = 0; i < rounds(12); ++i) {
    const Sphere a{random.point(0.6), random.in(0.5, 1)}, b{random.point(0.6), random.in(0.5, 1)};
    for (const Operation operation :
         {Operation::union_, Operation::intersection, Operation::difference}) {
      const Blend blend = blend_of(operation, 0, {placed(a), placed(b)});
      Faults faults;
      blend.check({}, faults);
      if (!faults.empty()) continue;  // nothing in common
      const IsosurfaceForm form = prepare(blend);
      const Vec3d from = random.vector(4, 6), d = normalize(random.point(1) - from);
      const double shift = dot(bounds(form).center() - from, d);
      std::vector<double> t;
      spans(form, Line{from + d * shift, d}, [&](double at, int) { t.push_back(at + shift); });
      Spans in_a, in_b, merged;
      crossings(a, Line{from, d}, [&](double at, int) { in_a.push_back({at, 0, 0}); });
      crossings(b, Line{from, d}, [&](double at, int) { in_b.push_back({at, 1, 0}); });
      merge(operation, in_a, in_b, 1e-9, merged);
      ASSERT_EQ(t.size(), merged.size()) << i;
      for (std::size_t k = 0; k < t.size(); ++k) EXPECT_NEAR(t[k], merged[k].t, 1e-8);
    }
  }
}

// The length of the vector of depths knows no order.
TEST(Blend, ManyChildrenJoinInAnyOrder) {
  Random random(5);
  for (int i = 0; i < rounds(6); ++i) {
    std::vector<Blended> children;
    for (int k = 0; k < 4; ++k) {
      const Vec3d center = random.point(0.8);
      children.push_back(placed(Sphere{center, random.in(0.3, 0.8)}));
    }
    const IsosurfaceForm form = prepare(blend_of(Operation::union_, 0.4, children));
    std::reverse(children.begin(), children.end());
    const IsosurfaceForm other = prepare(blend_of(Operation::union_, 0.4, children));
    const Vec3d from = random.vector(4, 6), way = random.point(0.8) - from;
    const auto t = crossings_from(form, from, way), u = crossings_from(other, from, way);
    ASSERT_EQ(t.size(), u.size());
    for (std::size_t k = 0; k < t.size(); ++k) EXPECT_NEAR(t[k], u[k], 1e-9);
  }
}

// Each kind by itself against its own form.
template <class Kind>
void expect_itself(const Kind& kind, Random& random) {
  const auto own = prepare(kind);
  const Vec3d moved = random.point(3);
  const double scale = random.in(0.3, 3);
  const IsosurfaceForm form = prepare(
      blend_of(Operation::union_, 0.3,
               {placed(kind, {Scale{scale}, RotateDegrees{{20, 30, 40}}, Translate{moved}})}));
  const Affine place =
      TransformSteps{{Scale{scale}, RotateDegrees{{20, 30, 40}}, Translate{moved}}}.affine();
  for (int i = 0; i < rounds(30); ++i) {
    const Vec3d from = random.vector(4, 6), d = normalize(random.point(0.8) - from);
    std::vector<double> expected;
    crossings(own, Line{from, d}, [&](double at, int) { expected.push_back(at * scale); });
    std::sort(expected.begin(), expected.end());
    const auto t = crossings_from(form, place.point(from), place.vector(d));
    ASSERT_EQ(t.size(), expected.size()) << Kind::type;
    for (std::size_t k = 0; k < t.size(); ++k) EXPECT_NEAR(t[k], expected[k], 1e-8) << Kind::type;
  }
}
TEST(Blend, OneChildIsThatChildWhereverItStands) {
  Random random(6);
  for (int i = 0; i < rounds(2); ++i) {
    expect_itself(Sphere{random.point(0.5), random.in(0.4, 1)}, random);
    expect_itself(Box{{-0.8, -0.5, -1}, {0.7, 0.9, 0.3}}, random);
    expect_itself(Cylinder{{-0.5, -0.6, 0}, random.point(0.3) + Vec3d{0.8, 0.7, 0}, 0.4}, random);
    expect_itself(Capsule{{-0.5, -0.6, 0}, random.point(0.3) + Vec3d{0.8, 0.7, 0}, 0.4}, random);
    expect_itself(Torus{0.9, random.in(0.1, 0.6)}, random);
  }
}

TEST(Blend, NothingInCommonIsNamed) {
  const Blend apart = blend_of(Operation::intersection, 0.1,
                               {placed(Sphere{{0, 0, 0}, 1}), placed(Sphere{{5, 0, 0}, 1})});
  Faults faults;
  apart.check({}, faults);
  ASSERT_EQ(faults.list().size(), 1U);
  EXPECT_EQ(faults.list().front().pointer, "/children");
}

}  // namespace
}  // namespace tia
