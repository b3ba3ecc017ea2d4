#include "core/shapes/simple/box.h"

#include "tests/core/shapes/lines.h"

namespace tia {
namespace {

using enum FaultKind;
using namespace test;

Long outside(const Box& box, const Vec3l& p) {
  const auto low = static_cast<Vec3l>(box.min) - p, high = p - static_cast<Vec3l>(box.max);
  return std::max({low.x, low.y, low.z, high.x, high.y, high.z});
}

TEST(Box, PairsNormalsAndElementsHoldOnRandomLines) {
  Random random(40);
  int seen = 0;
  for (const double scale : scales) {
    for (int i = 0; i < 40; ++i) {
      Box box{random.point(3) * scale, {}};
      const double x = random.in(0.1, 4), y = random.in(0.1, 4);
      box.max = box.min + Vec3d{x, y, random.in(0.1, 4)} * scale;
      seen += expect_solid(
          box, [&](const Vec3l& p) { return outside(box, p); }, bounds(box).center(), 4 * scale,
          random);
    }
  }
  EXPECT_GT(seen, 1500);
}

// Along every axis, both ways: the faces lie where they are, and carry their numbers.
TEST(Box, AxisLinesMeetOppositeFaces) {
  const Box box{{-1, -2, -3}, {4, 5, 6}};
  const std::vector<Crossing> x = crossings_along(box, {{-5, 0, 0}, {2, 0, 0}});
  ASSERT_EQ(x.size(), 2u);
  EXPECT_EQ(x[0].t, 2);
  EXPECT_EQ(x[0].element, 0);
  EXPECT_EQ(x[1].t, 4.5);
  EXPECT_EQ(x[1].element, 1);
  const std::vector<Crossing> y = crossings_along(box, {{0, 9, 0}, {0, -1, 0}});
  ASSERT_EQ(y.size(), 2u);
  EXPECT_EQ(y[0].t, 4);
  EXPECT_EQ(y[0].element, 3);
  EXPECT_EQ(y[1].t, 11);
  EXPECT_EQ(y[1].element, 2);
  const std::vector<Crossing> z = crossings_along(box, {{0, 0, 0}, {0, 0, 1}});
  ASSERT_EQ(z.size(), 2u);
  EXPECT_EQ(z[0].t, -3);
  EXPECT_EQ(z[0].element, 4);
  EXPECT_EQ(z[1].t, 6);
  EXPECT_EQ(z[1].element, 5);
}

TEST(Box, NormalsPointOutOfTheirFaces) {
  const Box box{{0, 0, 0}, {1, 1, 1}};
  const Vec3d expected[] = {{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}};
  for (int i = 0; i < 6; ++i) EXPECT_EQ(normal(box, {}, i), expected[i]);
}

// Half-open: two boxes side by side share no point of a line in their common face, and lose none.
TEST(Box, LineInAFacesPlaneIsInsideAtMinAndOutsideAtMax) {
  const Box box{{-1, -1, -1}, {1, 1, 1}};
  for (const double sign : {-1.0, 1.0}) {
    const std::vector<double> through =
        sign < 0 ? std::vector<double>{4, 6} : std::vector<double>{};
    expect_distances(roots_along(box, {{sign, 0.5, -5}, {0, 0, 1}}), through, 0);
    expect_distances(roots_along(box, {{0.5, sign, -5}, {0, 0, 1}}), through, 0);
    expect_distances(roots_along(box, {{-5, 0.5, sign}, {1, 0, 0}}), through, 0);
    expect_distances(roots_along(box, {{sign, sign, -5}, {-0.0, 0, 1}}), through, 0,
                     "along an edge");
    // From within the face's plane, but not parallel to it.
    expect_distances(roots_along(box, {{sign, 0, 0}, {-sign, 0, 0}}), {0, 2}, 0);
  }
}

// The diagonal plane x + y = 2 touches the unit-cube-like box [-1,1]^3 in an edge: both are one t.
TEST(Box, GrazedEdgeEmitsTwiceTheSame) {
  for (const double scale : {0.125, 1.0, 1024.0}) {
    const Box box{Vec3d{-1, -1, -1} * scale, Vec3d{1, 1, 1} * scale};
    expect_distances(roots_along(box, {Vec3d{3, -1, 0} * scale, {-1, 1, 0}}),
                     {2 * scale, 2 * scale}, 1e-15 * scale);
    expect_distances(roots_along(box, {Vec3d{3.01, -1, 0} * scale, {-1, 1, 0}}), {}, 0);
  }
}

TEST(Box, CrossesNothingOfNanAndOfNoDirection) {
  const Box box{{-1, -1, -1}, {1, 1, 1}};
  expect_nothing_from_nan(box);
  crossings(box, Line{{0, 0, 0}, {0, 0, 0}}, [](double, int) { ADD_FAILURE(); });
}

TEST(Box, UvRunAlongTheFace) {
  const Box box{{0, 0, 0}, {2, 4, 8}};
  EXPECT_EQ(uv(box, {0, 1, 2}, 0), (Vec2d{0.25, 0.25}));
  EXPECT_EQ(uv(box, {1, 4, 2}, 3), (Vec2d{0.25, 0.5}));
  EXPECT_EQ(uv(box, {1, 1, 8}, 5), (Vec2d{0.5, 0.25}));
}

TEST(Box, EmptyIsRefused) {
  for (const char* max : {"[0,1,1]", "[1,0,1]", "[1,1,0]", "[-1,-1,-1]"})
    expect_faults(faults_in<Box>(std::string(R"({"min":[0,0,0],"max":)") + max + "}"),
                  {{out_of_range, "/max", max, "above min in every component"}});
  expect_faults(faults_in<Box>("{}"), {{FaultKind::missing, "/min", "", "corner"},
                                       {FaultKind::missing, "/max", "", "corner"}});
  EXPECT_TRUE(faults_in<Box>(R"({"min":[0,0,0],"max":[1e-9,1,1]})").empty());
}

}  // namespace
}  // namespace tia
