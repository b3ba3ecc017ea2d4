// Geometry: what worlds share, in which order luminous lights stand behind it, and how much memory
// it holds.
#if defined(__GLIBC__)
#include <malloc.h>
#endif

#include "tests/core/accel/worlds.h"

namespace tia {
namespace {

using namespace test;

Light quad_light(const Vec3d& corner) {
  QuadLight quad;
  quad.corner = corner;
  quad.u = {1, 0, 0};
  quad.v = {0, 0, 1};
  Light light;
  light.kind = quad;
  return light;
}

// A scene of all kinds of things with luminous lights among them.
Scene lit_scene(Random& random) {
  Scene scene = mixed_scene(random, 15, 1);
  scene.objects.push_back(ball(random.point(5), 1, matte({}, {1, 1, 1})));
  for (int i = 0; i < 4; ++i) {
    scene.lights.push_back(sphere_light(random.point(10), random.in(0.5, 3)));
    scene.lights.push_back(quad_light(random.point(10)));
  }
  return scene;
}

TEST(Geometry, WorldsOfMovedLightsShareItAndAreAsIfCompiledAlone) {
  Random random(62);
  for (int i = 0; i < 20; ++i) {
    Scene scene = lit_scene(random);
    const auto shared = std::make_shared<const Geometry>(geometry_of(scene));
    for (int step = 0; step < 3; ++step) {
      for (Light& light : scene.lights) light.move_to(random.point(10), {});
      const World with = compile(scene, shared), alone = compile(scene);
      EXPECT_EQ(with.of_objects, shared);
      EXPECT_EQ(with.objects, alone.objects);
      ASSERT_EQ(with.lights.size(), alone.lights.size());
      for (std::size_t k = 0; k < with.lights.size(); ++k)
        EXPECT_EQ(with.lights[k].primitive, alone.lights[k].primitive);
      for (int k = 0; k < 200; ++k) {
        const Ray<float> ray = ray_in<float>(random_ray(random, 1, with));
        EXPECT_EQ(all_of(hit_of(with, ray)), all_of(hit_of(alone, ray)));
      }
    }
  }
}

TEST(Geometry, OfLightsStandsBehindThatOfObjects) {
  Scene scene;
  scene.objects = {object_of(Box{{-1, -1, -1}, {1, 1, 1}}), object_of(Sphere{{9, 0, 0}, 1})};
  scene.lights = {sphere_light({9, 0, 0}, 1), quad_light({-0.5, 1, -0.5}), quad_light({4, 0, 0}),
                  quad_light({4, 0, 0})};
  const World world = compile(scene);
  const auto part_below = [&](const Vec3f& p) {
    return hit_of(world, Ray<float>{p, {0, -1, 0}}).primitive;
  };
  EXPECT_EQ(part_below({9, 5, 0}), 1) << "a ball where a light is";
  EXPECT_EQ(part_below({0.1F, 5, 0.2F}), 0) << "a face in a light's plane";
  EXPECT_EQ(part_below({4.5F, 5, 0.2F}), 4) << "the first of two lights";
  EXPECT_EQ(world.primitive(4).object, 4);
  EXPECT_EQ(world.objects, 6);
  EXPECT_EQ(world.lights[2].primitive, 4);
}

#if defined(__GLIBC__) && !defined(__SANITIZE_THREAD__) && !defined(__clang__)
std::size_t in_use() {
  const struct mallinfo2 heap = mallinfo2();
  return heap.uordblks + heap.hblkhd;
}

// Many of one thing each.
std::vector<Scene> heavy_scenes() {
  Random random(63);
  std::vector<Scene> scenes(4);
  Mesh mesh;
  for (int i = 0; i < 30'000; ++i) {
    const Vec3d p = random.point(10);
    mesh.positions.values.insert(mesh.positions.values.end(), {p.x, p.y, p.z});
    mesh.normals.values.insert(mesh.normals.values.end(), {p.x, p.y, 1});
    mesh.uvs.values.insert(mesh.uvs.values.end(), {p.x, p.y});
    mesh.indices.values.push_back(static_cast<std::uint32_t>(i));
  }
  scenes[0].objects = {object_of(mesh)};
  for (int i = 0; i < 5000; ++i) {
    scenes[1].objects.push_back(ball(random.point(100), 0.1, matte({1, 0, 0})));
    scenes[2].objects.push_back(
        object_of(Csg{Operation::union_, {ball(random.point(9), 1), ball(random.point(9), 1)}}));
    scenes[3].objects.push_back(object_of(
        Quadric{{1, 2, 3, 0, 0, 0, 0, 0, 0, -random.in(1, 9)}, {}}, random_placement(random, 1)));
  }
  return scenes;
}

TEST(Geometry, BytesAreWhatTheAllocatorHasGiven) {
  if (test::sanitized()) GTEST_SKIP() << "has an allocator of its own";
  // From the heap: of a map of their own, what lies before a huge page counts as in use, and nobody
  // touches it.
  mallopt(M_MMAP_THRESHOLD, 32 << 20);
  for (const Scene& scene : heavy_scenes()) {
    const std::size_t before = in_use();
    const auto geometry = std::make_unique<Geometry>(geometry_of(scene));
    const auto taken = static_cast<double>(in_use() - before);
    std::size_t bytes = bytes_of(*geometry);
    for (const SharedMesh& mesh : geometry->meshes) bytes += bytes_of(*mesh);
    EXPECT_GT(taken, 500'000);
    EXPECT_NEAR(static_cast<double>(bytes) / taken, 1, 0.05);
  }
}
#endif

}  // namespace
}  // namespace tia
