#include "core/accel/world/trace.h"

#include <gtest/gtest.h>

#include <numeric>

#include "core/accel/world/winners.h"
#include "tests/core/random_scene.h"

namespace tia {
namespace {

using test::ball;
using test::matte;
using test::Random;

std::vector<int> all_balls(const World& world) {
  std::vector<int> all(world.balls.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

// ---- compile ----------------------------------------------------------------------------------

TEST(World, HoldsTheObjectsInOrderThenTheLuminousLights) {
  Scene scene;
  scene.background = {0.1, 0.2, 0.3};
  scene.objects = {ball({1, 0, 0}, 1), ball({2, 0, 0}, 2)};
  scene.lights = {test::sphere_light({3, 0, 0}, 3), test::point_light({9, 0, 0}),
                  test::sphere_light({4, 0, 0}, 4)};
  scene.key_light = test::sphere_light({5, 0, 0}, 5);
  const World world = compile(scene);
  ASSERT_EQ(world.balls.size(), 5U);
  EXPECT_EQ(world.objects, 5);
  for (int i = 0; i < 5; ++i) {
    const auto n = static_cast<double>(i + 1);
    EXPECT_EQ(world.balls[static_cast<std::size_t>(i)].sphere, (Sphere{{n, 0, 0}, n}));
    EXPECT_EQ(world.balls[static_cast<std::size_t>(i)].primitive, i);
    EXPECT_EQ(world.primitive(i).object, i);
  }
  EXPECT_EQ(world.background.exact, (Vec3d{0.1, 0.2, 0.3}));
}

TEST(World, HasALampForEachLightThatShines) {
  Scene scene;
  scene.objects = {ball({1, 0, 0}, 1), ball({2, 0, 0}, 1, matte({}, {0, 0, 0.5}))};
  scene.lights = {test::point_light({9, 0, 0}, {1, 2, 3}), test::sphere_light({4, 0, 0}, 1),
                  test::point_light({8, 0, 0}, {0, 0, 0})};
  scene.lights[0].intensity = 2;
  scene.key_light = Light{PointLight{}, {1, 1, 1}, 1};  // without a place: none
  const World world = compile(scene);
  ASSERT_EQ(world.lights.size(), 3U);
  const auto expect = [&](std::size_t i, const Vec3d& position, const Vec3d& color, int primitive) {
    EXPECT_EQ(world.lights[i].middle.exact, position) << i;
    EXPECT_EQ(world.lights[i].color.exact, color) << i;
    EXPECT_EQ(world.lights[i].primitive, primitive) << i;
  };
  expect(0, {2, 0, 0}, {0, 0, 0.5}, 1);
  expect(1, {9, 0, 0}, {2, 4, 6}, -1);
  expect(2, {4, 0, 0}, {1, 1, 1}, 2);
}

TEST(World, MaterialIsNamedOrOwnOrTheDefault) {
  Scene scene;
  scene.materials["red"] = Material{Finish{.color = {1, 0, 0}, .diffuse = 0.5}};
  scene.objects = {
      ball({}, 1),
      ball({}, 1, Material{Finish{.color = {0, 1, 0}, .diffuse = 0.25, .emission = {0, 0, 2}}}),
      ball({}, 1)};
  scene.objects[0].material = "red";
  scene.objects[2].material.reset();
  const World world = compile(scene);
  EXPECT_EQ(world.shading_of(0).albedo.exact, (Vec3d{0.5, 0, 0}));
  EXPECT_EQ(world.shading_of(1).albedo.exact, (Vec3d{0, 0.25, 0}));
  EXPECT_EQ(world.shading_of(1).emission.exact, (Vec3d{0, 0, 2}));
  EXPECT_EQ(world.shading_of(2).albedo.exact, (Vec3d{1, 1, 1}));
}

// ---- closest_hit, occluded --------------------------------------------------------------------

TEST(World, ClosestHitIsTheNearestOfAllObjects) {
  Random random(90);
  int hits = 0;
  for (int i = 0; i < 500; ++i) {
    const World world = compile(test::random_scene(static_cast<std::uint64_t>(i), 12));
    for (int k = 0; k < 20; ++k) {
      const Ray<double> ray{random.point(3), random.direction()};
      double nearest = infinity;
      int object = -1;
      for (std::size_t s = 0; s < world.balls.size(); ++s)
        if (const double t = intersect(world.balls[s].sphere, RootRay<double>(ray)); t < nearest) {
          nearest = t;
          object = static_cast<int>(s);
        }
      const Hit<double> hit = closest_ball(world, all_balls(world), ray);
      EXPECT_EQ(hit.t, nearest);
      EXPECT_EQ(hit.primitive, object);
      hits += object >= 0;
    }
  }
  EXPECT_GT(hits, 2000);
}

TEST(World, AtEqualDistanceTheEarlierObjectWins) {
  Scene scene;
  scene.objects = {ball({9, 9, 9}, 1), ball({0, 0, -5}, 1), ball({0, 0, -5}, 1),
                   ball({0, 0, -6}, 2)};  // all three start at z = -4
  const World world = compile(scene);
  EXPECT_EQ(closest_ball(world, all_balls(world), Ray<float>{{0, 0, 0}, {0, 0, -1}}).primitive, 1);
  EXPECT_EQ(closest_ball(world, all_balls(world), Ray<double>{{0, 0, 0}, {0, 0, -1}}).primitive, 1);
  const Wide zero(0), minus(-1);
  const Hit<Wide> hit =
      closest_ball(world, all_balls(world), Ray<Wide>{{zero, zero, zero}, {zero, zero, minus}});
  for (int k = 0; k < lanes<Wide>; ++k) EXPECT_EQ(lane(hit.primitive, k), 1);
}

TEST(World, ClosestHitTriesOnlyTheCandidates) {
  Scene scene;
  scene.objects = {ball({0, 0, -5}, 1), ball({0, 0, -10}, 1)};
  const World world = compile(scene);
  EXPECT_EQ(closest_ball(world, {1}, Ray<float>{{0, 0, 0}, {0, 0, -1}}).primitive, 1);
  EXPECT_EQ(closest_ball(world, {}, Ray<float>{{0, 0, 0}, {0, 0, -1}}).t, infinity);
}

TEST(World, OccludedMeansAnyHitBeforeTheDistanceButOnesOwn) {
  Scene scene;
  scene.objects = {ball({0, 0, -5}, 1), ball({0, 0, -10}, 1)};
  const World world = compile(scene);
  const Ray<float> ray{{0, 0, 0}, {0, 0, -1}};
  const WorldLight point;
  WorldLight first;
  first.primitive = 0;
  WorkCounter work;
  const auto dark = [&](const Ray<float>& way, float distance, const WorldLight& light) {
    const bool by_list = occluded_by_balls(world, way, distance, light);
    EXPECT_EQ(occluded(world, way, distance, light, true, work), by_list);
    return by_list;
  };
  EXPECT_TRUE(dark(ray, 20, point));
  EXPECT_TRUE(dark(ray, 4.5, point));
  EXPECT_FALSE(dark(ray, 4, point)) << "a hit at the very distance is beyond";
  EXPECT_FALSE(dark(ray, 3, point));
  EXPECT_TRUE(dark(ray, 20, first));
  EXPECT_FALSE(dark(ray, 8, first)) << "one's own never blocks";
  EXPECT_FALSE(dark({{0, 0, 0}, {0, 1, 0}}, 20, point));
}

// ---- surface ----------------------------------------------------------------------------------

TEST(World, EachWinnerAmongTheLanesIsVisitedOnce) {
  Hit<Wide> hit;
  hit.primitive = iota<Wide>() - select(iota<Wide>() < Wide(2), Wide(0), Wide(1));  // 0 1 1 2 ..
  const WideMask found = iota<Wide>() > Wide(0);
  hit.t = select(found, Wide(1), Wide(infinity));
  unsigned covered = 0;
  int visits = 0;
  for_each_winner(hit, WideMask(true), [&](int primitive, WideMask mask) {
    EXPECT_EQ(covered & bits(mask), 0U);
    covered |= bits(mask);
    for (int k = 0; k < lanes<Wide>; ++k) {
      const bool chosen = ((bits(mask) >> static_cast<unsigned>(k)) & 1U) != 0;
      EXPECT_TRUE(!chosen || lane(hit.primitive, k) == static_cast<float>(primitive));
    }
    ++visits;
  });
  EXPECT_EQ(covered, bits(found));
  EXPECT_EQ(visits, lanes<Wide> - 2);
}

TEST(World, SurfaceFacesTheViewer) {
  Scene scene;
  scene.objects = {ball({0, 0, -5}, 1), ball({0, 0, 0}, 2)};
  const World world = compile(scene);
  const auto seen = [&](const Ray<double>& ray, const std::vector<int>& objects) {
    const Hit<double> hit = closest_ball(world, objects, ray);
    return surface(world, ray, hit, static_cast<int>(hit.primitive), true);
  };
  const Ray<double> out{{0, 0, 0}, {0, 0, -1}}, in{{0, 0, 9}, {0, 0, -1}};
  EXPECT_EQ(seen(out, {0, 1}).p, (Vec3d{0, 0, -2}));
  EXPECT_EQ(seen(out, {0, 1}).n, (Vec3d{0, 0, 1})) << "from inside: turned to the viewer";
  EXPECT_EQ(seen(in, {0, 1}).p, (Vec3d{0, 0, 2}));
  EXPECT_EQ(seen(in, {0, 1}).n, (Vec3d{0, 0, 1}));
  EXPECT_EQ(seen(out, {0}).p, (Vec3d{0, 0, -4}));
}

// ---- candidates -------------------------------------------------------------------------------

TEST(World, CandidatesKeepTheScenesOrder) {
  const World world = compile(test::random_scene(91, 12));
  const View view = view_of({}, 640, 480);
  const auto found = candidates(world, Beam(view, 0, 0, 640, 480));
  EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
  EXPECT_FALSE(found.empty());
  EXPECT_LT(candidates(world, Beam(view, 0, 0, 8, 8)).size(), found.size());
}

}  // namespace
}  // namespace tia
