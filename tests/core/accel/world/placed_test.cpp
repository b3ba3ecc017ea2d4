// Transforms, groups and repeats: things in their places are what they would be, written out there.
#include <gtest/gtest.h>

#include "core/accel/world/all_hits.h"
#include "tests/core/accel/worlds.h"

namespace tia {
namespace {

using test::ball;
using test::hit_of;
using test::matte;
using test::object_of;
using test::Random;
using test::world_of;

TransformSteps steps(const std::vector<TransformSteps::Step>& list) { return {list}; }
Object group(const std::vector<Object>& children, const TransformSteps& place = {}) {
  return object_of(Group{children, {}}, place);
}
Object repeated(const std::vector<Object>& children, const Repeat& repeat,
                const TransformSteps& place = {}) {
  return object_of(Group{children, repeat}, place);
}
Normals normals_of(const World& world, const Ray<double>& ray, const Hit<double>& hit) {
  return normals_at(world, ray.at(hit.t), static_cast<int>(hit.primitive),
                    static_cast<int>(hit.element), static_cast<std::int64_t>(hit.instance));
}

// All rays meet both worlds at one place and under one normal.
void expect_same_hits(const World& a, const World& b, double extent, double slack = 1e-12) {
  Random random(500);
  int hits = 0;
  for (int i = 0; i < 4000; ++i) {
    const Vec3d target = random.point(extent), origin = random.direction() * (3 * extent);
    const Ray<double> ray{origin, normalize(target - origin)};
    const auto at = hit_of(a, ray), other = hit_of(b, ray);
    if (!(at.t < infinity) || !(other.t < infinity)) {
      ASSERT_EQ(at.t, other.t);
      continue;
    }
    ++hits;
    ASSERT_NEAR(at.t, other.t, slack * extent);
    EXPECT_LT(length(normals_of(a, ray, at).ng - normals_of(b, ray, other).ng), 1e4 * slack);
  }
  EXPECT_GT(hits, 40);
}

// ---- transforms -------------------------------------------------------------------------------

TEST(Placed, OrientedBoxIsMetWhereTheTurnedBackRayMeetsTheBox) {
  Random random(501);
  const Box box{{-1, -2, -0.5}, {1.5, 1, 2}};
  const World straight = world_of({object_of(box)});
  int hits = 0;
  for (int i = 0; i < 1000; ++i) {
    // About x by a, then about y by b: a point p goes to Y X p. The inverse is X^-1 Y^-1.
    const double a = random.in(-180, 180), b = random.in(-180, 180);
    const World turned = world_of({object_of(box, steps({RotateDegrees{{a, b, 0}}}))});
    const Vec3d origin = random.direction() * 5.0;
    const Ray<double> ray{origin, normalize(random.point(1) - origin)};
    const double ca = std::cos(a * pi / 180), sa = std::sin(a * pi / 180);
    const double cb = std::cos(b * pi / 180), sb = std::sin(b * pi / 180);
    const auto back = [&](const Vec3d& v) {
      // Y turns z towards x, X turns y towards z.
      const Vec3d w{cb * v.x - sb * v.z, v.y, sb * v.x + cb * v.z};
      return Vec3d{w.x, ca * w.y + sa * w.z, -sa * w.y + ca * w.z};
    };
    const auto expected = hit_of(straight, Ray<double>{back(ray.origin), back(ray.direction)});
    const auto hit = hit_of(turned, ray);
    if (std::isinf(hit.t) != std::isinf(expected.t)) continue;  // at the outline itself
    if (std::isinf(hit.t)) continue;
    ++hits;
    EXPECT_NEAR(hit.t, expected.t, 1e-10);
    EXPECT_EQ(hit.element, expected.element);
  }
  EXPECT_GT(hits, 150);
}

TEST(Placed, StretchedBallIsTheQuadric) {
  // ((x - 1) / 2)^2 + ((y + 1) / 0.5)^2 + (z / 1.5)^2 = 1, written out.
  const double a = 1 / 4.0, b = 4, c = 1 / 2.25;
  const Quadric quadric{{a, b, c, 0, 0, 0, -2 * a, 2 * b, 0, a + b - 1}, {}};
  const Object stretched =
      object_of(Sphere{{0, 0, 0}, 1}, steps({Scale{Vec3d{2, 0.5, 1.5}}, Translate{{1, -1, 0}}}));
  expect_same_hits(world_of({stretched}), world_of({object_of(quadric)}), 3);
}

TEST(Placed, BallUnderASimilarityIsTheBallWrittenThere) {
  // (1, 0, 0) by -2: (-2, 0, 0); by 90 degrees about z: (0, -2, 0); and 5 up.
  const Object placed =
      object_of(Sphere{{1, 0, 0}, 0.5},
                steps({Scale{-2.0}, RotateDegrees{{0, 0, 90}}, Translate{{0, 5, 0}}}));
  const World world = world_of({placed});
  ASSERT_EQ(world.balls.size(), 1U);
  EXPECT_LT(length(world.balls[0].sphere.center - Vec3d{0, 3, 0}), 1e-15);
  EXPECT_NEAR(world.balls[0].sphere.radius, 1, 1e-15);
}

TEST(Placed, ChildsTransformActsBeforeItsParents) {
  // The child moves (0,0,0) to (1,0,0), its parent turns that about z by 90 degrees to (0,1,0), and
  // the parent's parent doubles it: (0,2,0).
  const Object child = object_of(Sphere{{}, 0.25}, steps({Translate{{1, 0, 0}}}));
  const Object inner = group({child}, steps({RotateDegrees{{0, 0, 90}}}));
  const World world = world_of({group({inner}, steps({Scale{2.0}}))});
  EXPECT_LT(length(world.balls[0].sphere.center - Vec3d{0, 2, 0}), 1e-15);
  EXPECT_NEAR(world.balls[0].sphere.radius, 0.5, 1e-15);
  // The same steps on the object itself.
  const Object alone =
      object_of(Box{{-1, 0, 0}, {1, 2, 1}},
                steps({Translate{{1, 0, 0}}, RotateDegrees{{20, 30, 90}}, Scale{Vec3d{2, 1, 1}}}));
  const Object box = object_of(Box{{-1, 0, 0}, {1, 2, 1}}, steps({Translate{{1, 0, 0}}}));
  const Object nested =
      group({group({box}, steps({RotateDegrees{{20, 30, 90}}}))}, steps({Scale{Vec3d{2, 1, 1}}}));
  expect_same_hits(world_of({alone}), world_of({nested}), 4);
}

TEST(Placed, MirrorKeepsNormalsOutwards) {
  Random random(502);
  for (const Vec3d& mirror : {Vec3d{-1, 1, 1}, Vec3d{1, -2, 1}, Vec3d{-1, -1, -0.5}}) {
    for (int kind = 0; kind < 40; ++kind) {
      const Shape shape = test::random_solid(random, {}, 1);
      if (std::holds_alternative<Quadric>(shape)) continue;  // cut open, seen from inside too
      const World world = world_of({object_of(shape, steps({Scale{mirror}}))});
      for (int i = 0; i < 50; ++i) {
        const Vec3d origin = random.direction() * 9.0;
        const Ray<double> ray{origin, normalize(random.point(1) - origin)};
        const auto hits = all_hits(world, ray);
        // From outside: in, out, in, out.
        for (std::size_t k = 0; k < hits.size(); ++k) EXPECT_EQ(hits[k].front, k % 2 == 0);
      }
    }
  }
}

// ---- repeats ----------------------------------------------------------------------------------

std::vector<Object> motif() {
  TransformSteps place;
  place.steps = {RotateDegrees{{10, 20, 30}}, Scale{Vec3d{1, 0.5, 2}}};
  Mesh tetra;
  tetra.positions.values = {0, 0, 0, 0.5, 0, 0, 0, 0.5, 0, 0, 0, 0.5};
  tetra.indices.values = {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2};
  return {ball({0.2, 0.3, 0.1}, 0.3), object_of(Box{{-0.4, -0.4, -0.1}, {0, 0, 0.1}}, place),
          object_of(Csg{Operation::difference, {ball({0, 0, 0.5}, 0.3), ball({0, 0, 0.8}, 0.2)}}),
          object_of(tetra)};
}

// The repeat's instances, each a group of its own.
Object written_out(const std::vector<Object>& children, const Repeat& repeat,
                   const TransformSteps& place) {
  std::vector<Object> instances;
  for (int k = 0; k < repeat.count[2]; ++k)
    for (int j = 0; j < repeat.count[1]; ++j)
      for (int i = 0; i < repeat.count[0]; ++i)
        instances.push_back(group(
            children, steps({Translate{repeat.step * Vec3d{double(i), double(j), double(k)}}})));
  return group(instances, place);
}

TEST(Repeat, IsItsCopiesWrittenOut) {
  const TransformSteps place =
      steps({Scale{Vec3d{1, -0.8, 1.2}}, RotateDegrees{{40, 10, -20}}, Translate{{-2, 1, 0}}});
  for (const Repeat& repeat :
       {Repeat{{4, 3, 2}, {1.5, 1.7, 2.1}}, Repeat{{3, 2, 4}, {-1.5, 1.7, -2.1}},
        Repeat{{1, 1, 1}, {0, 0, 0}}, Repeat{{1, 9, 1}, {0, 0.25, 0}}}) {
    const World instances = world_of({repeated(motif(), repeat, place)});
    expect_same_hits(instances, world_of({written_out(motif(), repeat, place)}), 4);
    EXPECT_EQ(instances.of_objects->primitives.size(), 5U) << "one instance in memory";
  }
}

TEST(Repeat, OfRepeatsIsItsCopiesWrittenOut) {
  const Repeat inner{{2, 3, 1}, {1.1, -1.3, 0}}, outer{{2, 1, 3}, {4, 0, -3}};
  const TransformSteps place = steps({RotateDegrees{{0, 0, 30}}}), above = steps({Scale{0.5}});
  const World instances = world_of({repeated({repeated(motif(), inner, place)}, outer, above)});
  const World all = world_of({written_out({written_out(motif(), inner, place)}, outer, above)});
  expect_same_hits(instances, all, 3);
  EXPECT_EQ(instances.of_objects->primitives.size(), 5U);
}

// More copies than are entered in a tree one by one, beside the same as a row of rows, which are.
TEST(Repeat, OfManyIsARowOfRows) {
  const TransformSteps place = steps({Scale{Vec3d{1, -0.8, 1.2}}, RotateDegrees{{40, 10, -20}}});
  const World grid = world_of({repeated(motif(), {{91, 91, 1}, {1.5, 1.7, 0}}, place)});
  const World rows = world_of(
      {repeated({repeated(motif(), {{91, 1, 1}, {1.5, 0, 0}})}, {{1, 91, 1}, {0, 1.7, 0}}, place)});
  EXPECT_EQ(grid.of_objects->spaces[0].items.size(), 1U);
  EXPECT_EQ(rows.of_objects->spaces[0].items.size(), 91U);
  expect_same_hits(grid, rows, 60);
}

TEST(Repeat, CopiesOfOneAreNumberedInTheOrderOfXThenYThenZ) {
  const World world = world_of({repeated({ball({}, 0.2)}, {{4, 3, 2}, {1, 10, 100}})});
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 2; ++k) {
        const Vec3d center{double(i), 10.0 * j, 100.0 * k};
        const Ray<double> ray{center + Vec3d{0, 0, 0.1}, {0, 0, 1}};
        EXPECT_EQ(hit_of(world, ray).instance, i + 4 * (j + 3 * k));
      }
}

TEST(Repeat, OfAMillionHitsTheCopyThatStandsThere) {
  const World world = world_of({repeated({ball({}, 0.3)}, {{100, 100, 100}, {1, -1, 1}})});
  Random random(503);
  for (int n = 0; n < 300; ++n) {
    const int i = random.below(100), j = random.below(100), k = random.below(100);
    const Vec3d center{double(i), -double(j), double(k)};
    const auto hit = hit_of(world, Ray<double>{center, random.direction()});
    EXPECT_EQ(hit.instance, i + 100 * (j + 100 * k));
    EXPECT_NEAR(hit.t, 0.3, 1e-13);
  }
}

// A short text with many small grids is not compiled to many things, and those that stay grids are
// hit alike: in the other order others do.
TEST(Repeat, OfManySmallGridsHasFewThingsOfItsOwn) {
  constexpr int grids = 12;
  std::vector<Object> all;
  for (int i = 0; i < grids; ++i) {
    const Vec3d at{40.0 * i, 0, 0};
    const Object thing = i % 2 == 0 ? ball(at, 0.4) : object_of(Box{at, at + Vec3d{.5, .5, .5}});
    all.push_back(repeated({thing}, {{20, 20, 20}, {1, 1, 1}}));
  }
  const World world = world_of(all), backwards = world_of({all.rbegin(), all.rend()});
  const Geometry& geometry = *world.of_objects;
  const std::size_t things = geometry.balls.size() + geometry.spaces[0].items.size();
  EXPECT_GT(things, 60'000U);
  EXPECT_LE(things, 65'536U + grids);
  Random random(504);
  int hits = 0;
  for (int n = 0; n < 2000; ++n) {
    const Vec3d from = random.direction() * 900.0, in = random.point(1);
    const Vec3d to{240 * (1 + in.x), 10 * (1 + in.y), 10 * (1 + in.z)};
    const Ray<double> ray{from, normalize(to - from)};
    const auto hit = hit_of(world, ray), other = hit_of(backwards, ray);
    ASSERT_EQ(std::isinf(hit.t), std::isinf(other.t));
    if (std::isinf(hit.t)) continue;
    ++hits;
    ASSERT_NEAR(hit.t, other.t, 1e-9 * hit.t);
    ASSERT_EQ(hit.instance, other.instance);
  }
  EXPECT_GT(hits, 500);
}

// ---- materials and lights ----------------------------------------------------------------------

TEST(Placed, ObjectWithoutMaterialTakesItsNearestAncestors) {
  const auto bare = [](double x) { return object_of(Sphere{{x, 0, 0}, 0.25}); };
  Object own = bare(3);
  own.material = matte({0, 0, 1});
  Object inner = group({bare(1), own});
  Object outer = group({inner, bare(2)});
  outer.material = matte({1, 0, 0});
  Object row = repeated({bare(5)}, {{2, 1, 1}, {1, 0, 0}});
  row.material = matte({0, 1, 0});
  const World world = world_of({bare(0), outer, row});
  const auto color = [&](double x) {
    const auto hit = hit_of(world, Ray<double>{{x, 0, 5}, {0, 0, -1}});
    return world.shading_of(static_cast<int>(hit.primitive)).albedo.exact;
  };
  EXPECT_EQ(color(0), (Vec3d{1, 1, 1})) << "the default";
  EXPECT_EQ(color(1), (Vec3d{1, 0, 0})) << "its grandparent's";
  EXPECT_EQ(color(2), (Vec3d{1, 0, 0}));
  EXPECT_EQ(color(3), (Vec3d{0, 0, 1}));
  EXPECT_EQ(color(5), (Vec3d{0, 1, 0}));
  EXPECT_EQ(color(6), (Vec3d{0, 1, 0})) << "an instance's is the same";
}

TEST(Repeat, LuminousBallIsALampForEachCopy) {
  const Object glowing = ball({1, 0, 0}, 0.2, matte({0, 0, 0}, {1, 2, 3}));
  const Repeat inner{{2, 1, 1}, {3, 0, 0}}, outer{{1, 2, 1}, {0, 5, 0}};
  const World world = world_of({repeated({repeated({glowing}, inner, steps({Scale{2.0}}))}, outer,
                                         steps({Translate{{0, 0, -7}}}))});
  ASSERT_EQ(world.lights.size(), 4U);
  // Within the inner grid at x = 1 and 4, doubled: 2 and 8; y = 0 and 5; z = -7.
  std::vector<Vec3d> places;
  for (const WorldLight& light : world.lights) {
    EXPECT_EQ(light.color.exact, (Vec3d{1, 2, 3}));
    places.push_back(light.middle.exact);
  }
  for (const double x : {2.0, 8.0})
    for (const double y : {0.0, 5.0})
      EXPECT_EQ(std::count(places.begin(), places.end(), Vec3d{x, y, -7}), 1) << x << " " << y;
}

TEST(Repeat, LampsOwnCopyNeverBlocksItAndTheOthersDo) {
  const World world =
      world_of({repeated({ball({}, 0.2, matte({0, 0, 0}, {1, 1, 1}))}, {{2, 1, 1}, {1, 0, 0}})});
  WorkCounter work;
  // From x = -5 along x: the ball at 0, then the one at 1.
  const Ray<float> ray{{-5, 0, 0}, {1, 0, 0}};
  for (const WorldLight& light : world.lights) {
    const auto distance = static_cast<float>(light.middle.exact.x + 5);
    EXPECT_EQ(occluded(world, ray, distance, light, true, work), light.middle.exact.x > 0.5);
  }
}

}  // namespace
}  // namespace tia
