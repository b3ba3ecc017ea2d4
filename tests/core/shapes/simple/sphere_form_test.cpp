// The sphere as a form; its roots in the picture's scalars are sphere_test's.
#include "core/shapes/simple/sphere.h"
#include "tests/core/shapes/lines.h"

namespace tia {
namespace {

using namespace test;

TEST(SphereForm, PairsNormalsAndUvHoldOnRandomLines) {
  Random random(70);
  int seen = 0;
  for (const double scale : scales) {
    for (int i = 0; i < 40; ++i) {
      const Sphere s{random.point(5) * scale, random.in(0.2, 3) * scale};
      const auto outside = [&](const Vec3l& p) {
        const auto w = p - static_cast<Vec3l>(s.center);
        return std::sqrt(dot(w, w)) - static_cast<Long>(s.radius);
      };
      seen += expect_solid(s, outside, s.center, s.radius, random);
    }
  }
  EXPECT_GT(seen, 1500);
}

// At (1 -+ 1e-9) r from the centre a line just grazes: half its chord is sqrt(2e-9) r.
TEST(SphereForm, HitAndMissPartAtTheRadiusFromFarAndNear) {
  Random random(71);
  for (const double scale : scales) {
    for (int i = 0; i < 500; ++i) {
      const Sphere s{random.point(5) * scale, random.in(0.2, 3) * scale};
      const double share = random.chance(0.5) ? 1 - 1e-9 : 1 + 1e-9, half = std::sqrt(2e-9);
      const Vec3d side = random.direction(), way = normalize(cross(side, random.direction()));
      const double away = random.in(-100, 100) * s.radius;
      const auto roots = roots_along(s, {s.center + side * (share * s.radius) - way * away, way});
      if (share > 1) EXPECT_TRUE(roots.empty());
      else
        expect_distances(roots, {away - half * s.radius, away + half * s.radius}, 1e-6 * s.radius);
    }
  }
  expect_distances(roots_along(Sphere{{0, 0, 0}, 1}, {{-3, 1, 0}, {2, 0, 0}}), {1.5, 1.5}, 0);
}

TEST(SphereForm, CrossesNothingOfNan) { expect_nothing_from_nan(Sphere{{1, 2, 3}, 4}); }

TEST(SphereForm, UvAreLongitudeFromZToXAndLatitudeFromTheSouth) {
  const Sphere s{{1, 2, 3}, 2};
  const auto at = [&](const Vec3d& way) { return uv(s, s.center + way, 0); };
  EXPECT_EQ(at({0, 0, 2}), (Vec2d{0, 0.5}));
  EXPECT_EQ(at({2, 0, 0}), (Vec2d{0.25, 0.5}));
  EXPECT_EQ(at({0, 0, -2}), (Vec2d{0.5, 0.5}));
  EXPECT_EQ(at({-2, 0, 0}), (Vec2d{0.75, 0.5}));
  EXPECT_EQ(at({0, -2, 0}).v, 0);
  EXPECT_EQ(at({0, 2, 0}).v, 1);
  EXPECT_LT(at({-1e-300, 0, 2}).u, 1) << "just before the seam";
}

}  // namespace
}  // namespace tia
