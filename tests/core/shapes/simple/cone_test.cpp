#include "core/shapes/simple/cone.h"

#include "tests/core/shapes/lines.h"

namespace tia {
namespace {

using enum FaultKind;
using namespace test;

// Above 0 outside: how far above the ends' planes or beside the side's line, the larger of them.
Long outside(const Cone& cone, const Vec3l& p) {
  const auto base = static_cast<Vec3l>(cone.base), axis = static_cast<Vec3l>(cone.cap) - base;
  const Long height = std::sqrt(dot(axis, axis));
  const Long z = dot(p - base, axis) / height;
  const Vec3l aside = p - base - axis * (z / height);
  const Long growth = static_cast<Long>(cone.cap_radius) - static_cast<Long>(cone.base_radius);
  const Long beside =
      std::sqrt(dot(aside, aside)) - static_cast<Long>(cone.base_radius) - growth * z / height;
  return std::max({-z, z - height, beside * height / std::hypot(height, growth)});
}

int expect_cone(const Cone& cone, Random& random) {
  const double size = length(cone.cap - cone.base) / 2 + cone.base_radius + cone.cap_radius;
  return expect_solid(
      prepare(cone), [&](const Vec3l& p) { return outside(cone, p); }, (cone.base + cone.cap) * 0.5,
      size, random);
}

TEST(Cone, PairsNormalsAndElementsHoldOnRandomLines) {
  Random random(50);
  int seen = 0;
  for (const double scale : scales) {
    for (int i = 0; i < 40; ++i) {
      Cone cone{random.point(3) * scale, {}, random.in(0.1, 2) * scale, random.in(0.1, 2) * scale};
      cone.cap = cone.base + random.vector(0.3, 4) * scale;
      if (i % 4 == 1) cone.cap_radius = 0;
      if (i % 4 == 2) cone.base_radius = 0;
      if (i % 4 == 3) cone.cap_radius = cone.base_radius;
      seen += expect_cone(cone, random);
    }
  }
  EXPECT_GT(seen, 1500);
}

// y = 1 - r, 0 <= y <= 1: the section y = 0.25 is a circle of radius 0.75.
TEST(Cone, IsMetWhereItsSectionsEnd) {
  for (const double scale : scales) {
    const Frustum cone = prepare(Cone{{0, 0, 0}, Vec3d{0, 1, 0} * scale, scale, 0});
    const double y = 0.25 * scale, r = 0.75 * scale, near = 1e-14 * scale;
    expect_distances(roots_along(cone, {{-3 * scale, y, 0}, {1, 0, 0}}),
                     {3 * scale - r, 3 * scale + r}, near, "from outside");
    expect_distances(roots_along(cone, {{0, y, 0}, {0, 0, 1}}), {-r, r}, near, "from inside");
    // A chord 0.6 off the middle of that circle is half sqrt(0.75^2 - 0.6^2) = 0.45 long.
    expect_distances(roots_along(cone, {{-scale, y, 0.6 * scale}, {1, 0, 0}}),
                     {0.55 * scale, 1.45 * scale}, near);
    expect_distances(roots_along(cone, {{r / 3, -scale, 0}, {0, 1, 0}}), {scale, 1.75 * scale},
                     near, "along the axis, at 0.25: up to y = 0.75");
    expect_distances(roots_along(cone, {{0, -scale, 0}, {0, 1, 0}}), {scale, 2 * scale}, near,
                     "the axis, to the tip");
  }
}

// Along a side's line the quadratic loses its square; just inside it runs from the base to the tip.
TEST(Cone, LineAlongTheSideIsInsideOrOutside) {
  const Frustum cone = prepare(Cone{{0, 0, 0}, {0, 1, 0}, 1, 0});
  const double in = 0.01;
  expect_distances(roots_along(cone, {{1 - in, 0, 0}, {-1, 1, 0}}), {0, 1 - in / 2}, 1e-12,
                   "to the opposite side, x = y - 1");
  EXPECT_TRUE(roots_along(cone, {{1 + in, 0, 0}, {-1, 1, 0}}).empty());
}

TEST(Cylinder, PairsNormalsAndElementsHoldOnRandomLines) {
  Random random(51);
  int seen = 0;
  for (const double scale : scales) {
    for (int i = 0; i < 20; ++i) {
      Cylinder c{random.point(3) * scale, {}, random.in(0.1, 2) * scale};
      c.cap = c.base + random.vector(0.3, 4) * scale;
      const Cone same{c.base, c.cap, c.radius, c.radius};
      seen += expect_solid(
          prepare(c), [&](const Vec3l& p) { return outside(same, p); }, (c.base + c.cap) * 0.5,
          length(c.cap - c.base) / 2 + c.radius, random);
    }
  }
  EXPECT_GT(seen, 700);
}

TEST(Cylinder, AxisLinesRunFromEndToEnd) {
  for (const double scale : scales) {
    const Frustum can = prepare(Cylinder{Vec3d{0, 0, 1} * scale, Vec3d{0, 0, 3} * scale, scale});
    for (const double aside : {0.0, 0.5, 0.999}) {
      const std::vector<Crossing> up =
          crossings_along(can, {Vec3d{aside, 0, 0} * scale, {0, 0, 1}});
      ASSERT_EQ(up.size(), 2u) << aside;
      EXPECT_NEAR(up[0].t, scale, 1e-15 * scale);
      EXPECT_EQ(up[0].element, Frustum::base);
      EXPECT_NEAR(up[1].t, 3 * scale, 4e-15 * scale);
      EXPECT_EQ(up[1].element, Frustum::cap);
      const std::vector<Crossing> down =
          crossings_along(can, {Vec3d{0, aside, 5} * scale, {0, 0, -1}});
      ASSERT_EQ(down.size(), 2u);
      EXPECT_EQ(down[0].element, Frustum::cap);
      EXPECT_EQ(down[1].element, Frustum::base);
    }
    EXPECT_TRUE(roots_along(can, {Vec3d{1.001, 0, 0} * scale, {0, 0, 1}}).empty());
  }
}

// At the distance (1 -+ 1e-9) r from the axis a line just grazes: its chord is 2 sqrt(2e-9) r.
TEST(Cylinder, HitAndMissPartAtTheRadius) {
  Random random(52);
  for (const double scale : scales) {
    for (int i = 0; i < 500; ++i) {
      const Vec3d axis = random.direction(), side = normalize(cross(axis, random.direction()));
      const Vec3d base = random.point(2) * scale;
      const double r = random.in(0.1, 1) * scale;
      const Frustum can = prepare(Cylinder{base, base + axis * (4 * scale), r});
      const double share = random.chance(0.5) ? 1 - 1e-9 : 1 + 1e-9;
      const Vec3d foot = base + axis * (random.in(1, 3) * scale) + side * (share * r);
      const Vec3d way = cross(axis, side);
      const double away = random.in(-4, 4) * scale;
      const std::vector<double> roots = roots_along(can, {foot - way * away, way});
      if (share > 1) EXPECT_TRUE(roots.empty());
      else
        expect_distances(roots, {away - std::sqrt(2e-9) * r, away + std::sqrt(2e-9) * r}, 1e-6 * r);
    }
  }
  // Where all is exact in double, the tangent itself hits, twice in one place.
  const Frustum can = prepare(Cylinder{{0, -1, 0}, {0, 1, 0}, 1});
  expect_distances(roots_along(can, {{-3, 0.5, 1}, {1, 0, 0}}), {3, 3}, 0);
}

TEST(Cylinder, LineInAnEndsPlaneIsInsideAtTheBaseAndOutsideAtTheCap) {
  const Frustum can = prepare(Cylinder{{0, -1, 0}, {0, 1, 0}, 1});
  expect_distances(roots_along(can, {{-3, -1, 0}, {1, 0, 0}}), {2, 4}, 1e-15);
  expect_distances(roots_along(can, {{-3, 1, 0}, {1, 0, 0}}), {}, 0);
}

// A wire of radius 1e-3 and length 2000 near its end, crossed: t = 5 -+ 1e-3 for all that length.
TEST(Cylinder, LongWireKeepsItsRadius) {
  Random random(53);
  for (int i = 0; i < 100; ++i) {
    const Vec3d axis = random.direction(), across = normalize(cross(axis, random.direction()));
    const Vec3d slanted = normalize(across + axis * random.in(-1, 1));
    const double sine = length(cross(axis, slanted)), r = 1e-3;
    const Frustum wire = prepare(Cylinder{axis * -1000.0, axis * 1000.0, r});
    expect_distances(roots_along(wire, {axis * 900.0 - slanted * 5.0, slanted}),
                     {5 - r / sine, 5 + r / sine}, 1e-9);
  }
}

TEST(Frustum, CrossesNothingOfNan) {
  expect_nothing_from_nan(prepare(Cylinder{{0, -1, 0}, {0, 1, 0}, 1}));
  expect_nothing_from_nan(prepare(Cone{{0, -1, 0}, {1, 1, 0}, 1, 0}));
}

TEST(Frustum, TipHasANormalAlongTheAxis) {
  EXPECT_EQ(normal(prepare(Cone{{0, 0, 0}, {0, 2, 0}, 1, 0}), {0, 2, 0}, 0), (Vec3d{0, 1, 0}));
  EXPECT_EQ(normal(prepare(Cone{{0, 0, 0}, {0, 2, 0}, 0, 1}), {0, 0, 0}, 0), (Vec3d{0, -1, 0}));
}

TEST(Frustum, UvOfTheSideRunFromBaseToCap) {
  const Frustum can = prepare(Cylinder{{0, 0, 0}, {0, 4, 0}, 1});
  EXPECT_EQ(uv(can, {0, 0, 1}, Frustum::side).v, 0);
  EXPECT_EQ(uv(can, {0, 3, 1}, Frustum::side).v, 0.75);
  EXPECT_EQ(uv(can, {0, 4, 0}, Frustum::cap), (Vec2d{0.5, 0.5}));
  // A quarter turn is a quarter of u.
  const double step = uv(can, {1, 2, 0}, 0).u - uv(can, {0, 2, 1}, 0).u;
  EXPECT_NEAR(std::fabs(std::remainder(step, 1.0)), 0.25, 1e-15);
}

TEST(Frustum, WithoutHeightOrWidthIsRefused) {
  expect_faults(faults_in<Cylinder>(R"({"base":[1,2,3],"cap":[1,2,3],"radius":1})"),
                {{out_of_range, "/cap", "[1,2,3]", "a point other than base"}});
  expect_faults(faults_in<Cylinder>(R"({"base":[0,0,0],"cap":[0,1e-10,0],"radius":1})"),
                {{out_of_range, "/cap", "[0,1e-10,0]", "1e-9 of the radius"}});
  expect_faults(faults_in<Cone>(R"({"base":[1,2,3],"cap":[1,2,3],"base_radius":1})"),
                {{out_of_range, "/cap", "[1,2,3]", "a point other than base"}});
  expect_faults(faults_in<Cone>(R"({"base":[1,2,3],"cap":[1,2,4],"base_radius":0})"),
                {{out_of_range, "/cap_radius", "0", "above 0 where base_radius is 0"}});
  expect_faults(faults_in<Cone>(R"({"base":[1,2,3],"cap":[1,2,4],"cap_radius":-1})"),
                {{FaultKind::missing, "/base_radius", "", "radius"},
                 {out_of_range, "/cap_radius", "-1", "from 0"}});
  EXPECT_TRUE(faults_in<Cone>(R"({"base":[1,2,3],"cap":[1,2,4],"base_radius":1})").empty());
  EXPECT_TRUE(faults_in<Cylinder>(R"({"base":[0,0,0],"cap":[0,1e-5,0],"radius":1})").empty());
}

}  // namespace
}  // namespace tia
