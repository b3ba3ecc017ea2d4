#include "core/shapes/simple/triangle.h"

#include "tests/core/shapes/lines.h"

namespace tia {
namespace {

using enum FaultKind;
using namespace test;

// A point a + u (b - a) + v (c - a) is chosen, then a line through it: t, u, v are known.
TEST(Triangle, IsHitWhereTheBarycentricCoordinatesSay) {
  Random random(60);
  for (const double scale : scales) {
    int hits = 0, misses = 0;
    for (int i = 0; i < 3000; ++i) {
      const Vec3d a = random.point(3) * scale, b = random.point(3) * scale;
      const Triangle triangle{a, b, random.point(3) * scale};
      const Vec3d to_b = b - a, to_c = triangle.c - a, area = cross(to_b, to_c);
      if (length(area) < 0.1 * length(to_b) * length(to_c)) continue;
      const double u = random.in(-0.5, 1.2), v = random.in(-0.5, 1.2);
      const Vec3d target = a + to_b * u + to_c * v;
      const Vec3d origin = target + random.vector(0.5, 5) * scale;
      const double pace = random.in(-3, 3);
      const SceneLine line{origin, (target - origin) * (1 / pace)};
      if (std::fabs(dot(normalize(line.direction), normalize(area))) < 0.1) continue;
      const TriangleForm form = prepare(triangle);
      const std::vector<double> roots = roots_along(form, line);
      const double inside = std::min({u, v, 1 - u - v});
      if (std::fabs(inside) < 1e-9) continue;
      (inside > 0 ? hits : misses) += 1;
      if (inside < 0) {
        EXPECT_TRUE(roots.empty());
        continue;
      }
      ASSERT_EQ(roots.size(), 1u);
      EXPECT_NEAR(roots[0], pace, 1e-11);
      const Vec2d place = uv(form, target, 0);
      EXPECT_NEAR(place.u, u, 1e-12);
      EXPECT_NEAR(place.v, v, 1e-12);
      const auto n = static_cast<Vec3l>(area);
      expect_on_surface(
          form,
          [&](const Vec3l& p) { return dot(p - static_cast<Vec3l>(a), n) / std::sqrt(dot(n, n)); },
          line.at(static_cast<Long>(roots[0])), 0, 10 * scale);
    }
    EXPECT_GT(hits, 300);
    EXPECT_GT(misses, 600);
  }
}

TEST(Triangle, RayThroughAnEdgeOrACornerHits) {
  for (const double scale : {0.125, 1.0, 1024.0}) {
    const TriangleForm form =
        prepare(Triangle{{0, 0, 0}, Vec3d{4, 0, 0} * scale, Vec3d{0, 4, 0} * scale});
    for (const Vec3d& p : {Vec3d{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {2, 0, 0}, {0, 1, 0}, {2, 2, 0}}) {
      const Vec3d origin = (p + Vec3d{0, 0, 2}) * scale;
      expect_distances(roots_along(form, {origin, {0, 0, -1}}), {2 * scale}, 0);
    }
    for (const Vec3d& p : {Vec3d{-1e-9, 1, 0}, {1, -1e-9, 0}, {2, 2 + 1e-9, 0}}) {
      const Vec3d origin = (p + Vec3d{0, 0, 2}) * scale;
      EXPECT_TRUE(roots_along(form, {origin, {0, 0, -1}}).empty());
    }
  }
}

TEST(Triangle, RayInItsPlaneMisses) {
  const TriangleForm form = prepare(Triangle{{0, 1, 0}, {4, 1, 0}, {0, 1, 4}});
  EXPECT_TRUE(roots_along(form, {{-5, 1, 1}, {1, 0, 0}}).empty());
  expect_nothing_from_nan(form);
}

TEST(Triangle, IsSeenCounterClockwiseFromWhereItsNormalPoints) {
  EXPECT_FALSE(TriangleForm::solid);
  EXPECT_EQ(normal(prepare(Triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), {}, 0), (Vec3d{0, 0, 1}));
  EXPECT_EQ(normal(prepare(Triangle{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}), {}, 0), (Vec3d{0, 0, -1}));
}

TEST(Triangle, OfNoAreaIsRefused) {
  const auto refused = [](const char* b, const char* c) {
    expect_faults(
        faults_in<Triangle>(std::string(R"({"a":[1,1,1],"b":)") + b + R"(,"c":)" + c + "}"),
        {{out_of_range, "/c", c, "not on the line through a and b"}});
  };
  refused("[2,2,2]", "[5,5,5]");
  refused("[2,2,2]", "[-1,-1,-1]");
  refused("[2,2,2]", "[1,1,1]");
  refused("[1,1,1]", "[3,4,5]");
  EXPECT_TRUE(faults_in<Triangle>(R"({"a":[1,1,1],"b":[2,2,2],"c":[5,5,5.000001]})").empty());
}

}  // namespace
}  // namespace tia
