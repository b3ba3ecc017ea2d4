#include "core/shapes/simple/plane.h"

#include "tests/core/shapes/lines.h"

namespace tia {
namespace {

using enum FaultKind;
using namespace test;

TEST(Plane, AsASolidIsTheHalfSpaceBehindItsNormal) {
  Random random(20);
  int seen = 0;
  for (const double scale : scales) {
    for (int i = 0; i < 40; ++i) {
      const Plane plane{random.point(2) * scale, random.vector(1e-3, 1e3)};
      const auto n = static_cast<Vec3l>(plane.normal);
      const auto side = [&](const Vec3l& p) {
        return dot(p - static_cast<Vec3l>(plane.point), n) / std::sqrt(dot(n, n));
      };
      seen += expect_solid(prepare(plane), side, plane.point, 3 * scale, random, false);
    }
  }
  EXPECT_GT(seen, 2000);
}

// From (0, 5, 0) along (1, -2, 0) the plane y = 1 is met after 2; it is entered downwards.
TEST(Plane, IsEnteredAgainstItsNormalAndLeftAlongIt) {
  for (const double scale : scales) {
    const PlaneForm floor = prepare(Plane{{0, scale, 0}, {0, 3, 0}});
    const Vec3d above{0, 5 * scale, 0}, below{0, -3 * scale, 0};
    expect_distances(roots_along(floor, {above, {1, -2, 0}}), {2 * scale, Aabb::far},
                     1e-15 * scale);
    expect_distances(roots_along(floor, {above, {1, 2, 0}}), {-Aabb::far, -2 * scale},
                     1e-15 * scale);
    expect_distances(roots_along(floor, {below, {1, 2, 0}}), {-Aabb::far, 2 * scale},
                     1e-15 * scale);
    expect_distances(roots_along(floor, {below, {1, -2, 0}}), {-2 * scale, Aabb::far},
                     1e-15 * scale);
  }
}

TEST(Plane, HoldsAParallelLineWhollyOrNotAtAll) {
  const PlaneForm floor = prepare(Plane{{0, 1, 0}, {0, 1, 0}});
  expect_distances(roots_along(floor, {{0, 0.5, 0}, {1, 0, 2}}), {-Aabb::far, Aabb::far}, 0);
  expect_distances(roots_along(floor, {{0, 1.5, 0}, {1, 0, 2}}), {}, 0);
  expect_distances(roots_along(floor, {{0, 1, 0}, {1, 0, 2}}), {}, 0, "in the plane");
}

TEST(Plane, CrossesNothingOfNan) { expect_nothing_from_nan(prepare(Plane{{0, 1, 0}, {1, 1, 1}})); }

// The normals 1e-200 and 1e9 long have squares of 0 and infinity in double's range or near it.
TEST(Plane, TakesANormalOfAnyLength) {
  for (const double size : {5e-324, 1e-200, 1e9}) {
    const PlaneForm plane = prepare(Plane{{0, 0, 0}, {0, 0, -size}});
    EXPECT_EQ(normal(plane, {}, 0), (Vec3d{0, 0, -1})) << size;
  }
}

TEST(Plane, UvAreItsOwnUnitsFromItsPoint) {
  Random random(21);
  for (int i = 0; i < 100; ++i) {
    const Plane plane{random.point(2), random.vector(0.1, 3)};
    const PlaneForm form = prepare(plane);
    const Vec3d a = plane.point + cross(plane.normal, random.point(1));
    const Vec3d b = plane.point + cross(plane.normal, random.point(1));
    const Vec2d at_a = uv(form, a, 0), at_b = uv(form, b, 0);
    EXPECT_NEAR(std::hypot(at_a.u - at_b.u, at_a.v - at_b.v), length(a - b), 1e-13);
    EXPECT_EQ(uv(form, plane.point, 0), (Vec2d{0, 0}));
  }
}

TEST(Plane, WithoutADirectionIsRefused) {
  expect_faults(faults_in<Plane>(R"({"point":[0,0,0],"normal":[0,0,0]})"),
                {{out_of_range, "/normal", "[0,0,0]", "a direction of some length"}});
  expect_faults(faults_in<Plane>(R"({"point":[0,2e9,0],"nromal":[0,1,0]})"),
                {{out_of_range, "/point/1", "2000000000", "from -1000000000 to 1000000000"},
                 {FaultKind::missing, "/normal", "", "perpendicular"},
                 {FaultKind::unknown_name, "/nromal", "\"nromal\"", "one of", "normal"}});
  EXPECT_TRUE(faults_in<Plane>(R"({"point":[1,2,3],"normal":[0,0,-2]})").empty());
}

// Duff et al. 2017: the basis is good at either pole, where others break down.
TEST(Onb, IsOrthonormalAndRightHandedEverywhere) {
  Random random(22);
  for (int i = 0; i < 1000; ++i) {
    Vec3d n = random.direction();
    if (i < 4) n = {0, i % 2 == 0 ? 0.0 : -0.0, i < 2 ? 1.0 : -1.0};
    if (i >= 4 && i < 100) n = unit({n.x * 1e-9, n.y * 1e-9, n.z});
    const Onb basis = onb_around(n);
    EXPECT_EQ(basis.n, n);
    EXPECT_NEAR(length(basis.u), 1, 1e-14);
    EXPECT_NEAR(length(basis.v), 1, 1e-14);
    EXPECT_LT(length(cross(basis.u, basis.v) - n), 1e-14);
  }
}

}  // namespace
}  // namespace tia
