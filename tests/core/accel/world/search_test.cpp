// The index against brute force: the same hits, bit for bit, whatever the world and the rays.
#include "core/accel/world/search.h"

#include <gtest/gtest.h>

#include "tests/core/accel/worlds.h"

namespace tia {
namespace {

using test::all_of;
using test::hit_of;
using test::lane_of;
using test::object_of;
using test::Random;
using test::ray_in;

const int object_count = test::sanitized() ? 100 : 1000, packet_count = test::sanitized() ? 10 : 42;

std::vector<Ray<float>> some_rays(Random& random, double scale, const World& world) {
  std::vector<Ray<float>> rays;
  for (std::size_t k = 0; k < Wide::size; ++k)
    rays.push_back(ray_in<float>(random_ray(random, scale, world)));
  return rays;
}

// ---- closest_hit ------------------------------------------------------------------------------

class MixedWorld : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Scales, MixedWorld, testing::Values(1e-3, 1.0, 1e3));

// 5 x 42 x 16 rays a scale, together 10^4; the thousand objects at the scale of 1.
TEST_P(MixedWorld, ClosestHitEqualsBruteForceInEveryWidth) {
  Random random(200);
  int hits = 0, in_copies = 0;
  const int some = GetParam() == 1 ? object_count : object_count / 4;
  const Scene scene = test::mixed_scene(random, some, GetParam());
  const World world = compile(scene), brute = test::without_index(world);
  for (int i = 0; i < 5 * packet_count; ++i) {
    const auto rays = some_rays(random, GetParam(), world);
    const Hit<Wide> wide = hit_of(world, test::packed(rays));
    for (int k = 0; k < lanes<Wide>; ++k) {
      const Ray<float>& ray = rays[static_cast<std::size_t>(k)];
      const auto expected = all_of(hit_of(brute, ray));
      ASSERT_EQ(all_of(hit_of(world, ray)), expected) << i << " " << k;
      ASSERT_EQ(all_of(lane_of(wide, k)), expected) << i << " " << k;
      hits += expected[0] < infinity;
      in_copies += expected[0] < infinity && expected[3] > 0;
    }
    const Ray<double> ray = random_ray(random, GetParam(), world);
    ASSERT_EQ(all_of(hit_of(world, ray)), all_of(hit_of(brute, ray)));
  }
  EXPECT_GT(hits, 16 * packet_count);
  if (GetParam() == 1) {
    EXPECT_GT(in_copies, 5);
  }
}

TEST_P(MixedWorld, OccludedEqualsBruteForceInEveryWidth) {
  Random random(201);
  const Scene scene = test::mixed_scene(random, object_count / 10, GetParam());
  const World world = compile(scene), brute = test::without_index(world);
  const WorldLight light;
  WorkCounter work;
  int dark = 0, all = 0;
  for (int i = 0; i < 5 * packet_count; ++i) {
    const auto rays = some_rays(random, GetParam(), world);
    const float far = static_cast<float>(random.in(0, 20) * GetParam());
    const auto wide = occluded(world, test::packed(rays), Wide(far), light, WideMask(true), work);
    for (std::size_t k = 0; k < Wide::size; ++k) {
      const bool expected = hit_of(brute, rays[k]).t < far;
      ASSERT_EQ(occluded(world, rays[k], far, light, true, work), expected);
      ASSERT_EQ((bits(wide) >> k & 1U) != 0, expected);
      dark += expected;
      ++all;
    }
  }
  EXPECT_GT(dark, all / 20);
  EXPECT_LT(dark, all - all / 20);
}

// A lane is the same whatever its neighbours are and whether they are active.
TEST_P(MixedWorld, LanesThatAreNotActiveChangeNothing) {
  Random random(202);
  const World world = compile(test::mixed_scene(random, object_count / 10, GetParam()));
  for (int i = 0; i < packet_count; ++i) {
    const auto rays = some_rays(random, GetParam(), world);
    const Wide number = iota<Wide>();
    WorkCounter work;
    const int from = random.below(lanes<Wide>);
    const auto active = number >= Wide(static_cast<float>(from));
    const Hit<Wide> hit = closest_hit(world, test::packed(rays), active, work);
    for (int k = 0; k < lanes<Wide>; ++k) {
      const auto alone = all_of(hit_of(world, rays[static_cast<std::size_t>(k)]));
      if (k >= from) {
        EXPECT_EQ(all_of(lane_of(hit, k)), alone);
      } else {
        EXPECT_EQ(lane(hit.t, k), infinity);
      }
    }
  }
}

TEST(Search, RaysOfNothingHitNothingAmongOtherRays) {
  Random random(203);
  const World world = compile(test::mixed_scene(random, object_count / 10, 1));
  const float nan = std::nanf("");
  for (int i = 0; i < packet_count; ++i) {
    auto rays = some_rays(random, 1, world);
    rays[3].origin.y = nan;
    rays[4].direction = {nan, nan, nan};
    rays[5] = {{nan, nan, nan}, {nan, nan, nan}};
    rays[6].direction = {0, 0, 0};
    rays[7].direction.z = nan;
    const Hit<Wide> hit = hit_of(world, test::packed(rays));
    for (int k = 0; k < lanes<Wide>; ++k) {
      const Ray<float>& ray = rays[static_cast<std::size_t>(k)];
      ASSERT_EQ(all_of(lane_of(hit, k)), all_of(hit_of(world, ray)));
      if (k >= 3 && k < 8) {
        ASSERT_EQ(hit_of(world, ray).t, infinity) << k;
      }
    }
  }
}

// ---- ties -------------------------------------------------------------------------------------

// Things that a ray along -z meets at z = -4, t = 4 exactly, whatever their kind.
std::vector<Object> all_at_four() {
  Mesh mesh;
  mesh.positions.values = {-3, -3, -4, 3, -3, -4, 0, 4, -4};
  mesh.indices.values = {0, 1, 2};
  const Object box = object_of(Box{{-1, -1, -6}, {1, 1, -4}});
  TransformSteps there;
  there.steps = {Translate{{0, 0, -5}}};
  return {test::ball({0, 0, -5}, 1),
          object_of(Csg{Operation::difference, {box, test::ball({9, 0, -5}, 1)}}),
          box,
          object_of(Disc{{0, 0, -4}, {0, 0, 1}, 1}),
          object_of(mesh),
          object_of(Group{{test::ball({0, 0, -5}, 1)}, Repeat{{2, 1, 1}, {7, 0, 0}}}),
          object_of(Box{{-1, -1, -1}, {1, 1, 1}}, there),
          object_of(Triangle{{-3, -3, -4}, {3, -3, -4}, {0, 4, -4}}),
          object_of(Plane{{0, 0, -4}, {0, 0, 1}}),
          object_of(Group{{box}, {}})};
}

TEST(Search, AtEqualDistanceTheObjectEarlierInTheSceneWinsWhateverTheirKinds) {
  Random random(204);
  for (int i = 0; i < 200; ++i) {
    Scene scene;
    std::vector<Object> all = all_at_four();
    while (!all.empty()) {
      const int next = random.below(static_cast<int>(all.size()));
      scene.objects.push_back(all[static_cast<std::size_t>(next)]);
      all.erase(all.begin() + next);
    }
    const World world = compile(scene);
    const Ray<float> ray{{0.25F, 0.125F, 0}, {0, 0, -1}};
    const Ray<float> middle{{0, 0, 0}, {0, 0, -1}};
    for (const auto& each : {hit_of(world, middle), hit_of(test::without_index(world), middle)}) {
      EXPECT_EQ(each.t, 4);
      EXPECT_EQ(world.primitive(static_cast<int>(each.primitive)).object, 0);
    }
    const bool round_first =
        all_at_four()[0] == scene.objects[0] || all_at_four()[5] == scene.objects[0];
    if (!round_first) {
      EXPECT_EQ(world.primitive(static_cast<int>(hit_of(world, ray).primitive)).object, 0);
    }
  }
}

TEST(Search, AtEqualDistanceTheFirstCopyAndTheFirstTriangleWin) {
  // InstanceGrid that overlap: box 0 spans x in [0, 10], each next one 1 to the right.
  Scene scene;
  scene.objects = {
      object_of(Group{{object_of(Box{{0, 0, -5}, {10, 1, -4}})}, Repeat{{8, 1, 1}, {1, 0, 0}}})};
  const Hit<float> hit = hit_of(compile(scene), Ray<float>{{9.5F, 0.5F, 0}, {0, 0, -1}});
  EXPECT_EQ(hit.t, 4);
  EXPECT_EQ(hit.instance, 0);
  const Hit<float> right = hit_of(compile(scene), Ray<float>{{12.5F, 0.5F, 0}, {0, 0, -1}});
  EXPECT_EQ(right.instance, 3) << "the instances 3 and on are there";
  Mesh mesh;  // the same triangle many times
  mesh.positions.values = {-3, -3, -4, 3, -3, -4, 0, 4, -4};
  for (int i = 0; i < 40; ++i) mesh.indices.values.insert(mesh.indices.values.end(), {0U, 1U, 2U});
  scene.objects = {object_of(mesh)};
  EXPECT_EQ(hit_of(compile(scene), Ray<float>{{0, 0, 0}, {0, 0, -1}}).element, 0);
}

// A strip of squares from x = i to i + 1, each of two triangles: where x = i they meet, in the
// plane of faces of both their boxes, in which a ray along z runs.
TEST(Search, RayInThePlaneOfABoxesFaceMeetsWhatIsThere) {
  Mesh mesh;
  std::vector<Object> discs;
  for (unsigned i = 0; i <= 100; ++i) {
    mesh.positions.values.insert(mesh.positions.values.end(), {double(i), 0, -1, double(i), 1, -1});
    discs.push_back(object_of(Disc{{double(i) - 0.5, 0.5, -1}, {0, 0, 1}, 0.5}));
    const unsigned a = 2 * i;
    if (i < 100)
      mesh.indices.values.insert(mesh.indices.values.end(), {a, a + 2, a + 3, a, a + 3, a + 1});
  }
  Scene strip, row;
  strip.objects = {object_of(mesh)};
  row.objects = discs;
  const World triangles = compile(strip), circles = compile(row);
  for (int i = 1; i < 100; ++i) {
    const Ray<float> ray{{static_cast<float>(i), 0.5F, 0}, {0, 0, -1}};
    EXPECT_EQ(hit_of(triangles, ray).element, 2 * i - 2) << "the first of the two that share it";
    EXPECT_EQ(hit_of(circles, ray).primitive, i) << "the first of the two that touch there";
  }
}

// ---- cost -------------------------------------------------------------------------------------

// Tests of boxes and surfaces a ray, on average, among n balls spread evenly in a cube, a ninth of
// which they fill: a ray meets one within a few times their distance, however many there are.
double tests_a_ray(int n) {
  Random random(205);
  Scene scene;
  for (int i = 0; i < n; ++i)
    scene.objects.push_back(test::ball(random.point(10), 6 / std::cbrt(double(n))));
  const World world = compile(scene);
  WorkCounter work;
  constexpr int rays = 500;
  for (int i = 0; i < rays; ++i)
    closest_hit(world, ray_in<float>({random.point(10), random.direction()}), true, work);
  return double(work.tests()) / rays;
}

TEST(Search, WorkGrowsAsTheLogarithmOfTheBalls) {
  // log 10^4 / log 10^2 = 2 and log 10^5 / log 10^2 = 2.5; a list would grow 100 and 1000 times.
  const double few = tests_a_ray(100), many = tests_a_ray(10'000);
  EXPECT_LT(many, 3 * few);
  if (!test::sanitized()) {
    EXPECT_LT(tests_a_ray(100'000), 4 * few);
  }
}

TEST(Search, AMillionCopiesCostAsManyTestsAsTheirLogarithm) {
  Scene scene;
  scene.objects = {object_of(Group{{test::ball({}, 0.3)}, Repeat{{100, 100, 100}, {1, 1, 1}}})};
  const World world = compile(scene);
  Random random(206);
  WorkCounter work;
  constexpr int rays = 200;
  for (int i = 0; i < rays; ++i) {
    const Vec3d target = Vec3d{50, 50, 50} + random.point(40);
    const Vec3d origin = Vec3d{50, 50, 50} + random.direction() * 200.0;
    closest_hit(world, ray_in<float>({origin, normalize(target - origin)}), true, work);
  }
  EXPECT_LT(work.tests() / rays, 200);
}

}  // namespace
}  // namespace tia
