// How much of compiled scenes is kept, and what falls out when.
#include <thread>

#include "tests/server/stores/geometry_support.h"

namespace tia::test {
namespace {

std::size_t bytes_alone(const Scene& scene) {
  GeometryStore store(plenty);
  compile_in(store, scene);
  return store.counts().bytes;
}

TEST(GeometryStore, OfNoBytesKeepsAndCountsNothing) {
  GeometryStore store(0);
  const Scene scene = any_scene(1);
  EXPECT_EQ(pixels_of(compiled(store, scene), scene), pixels_of(compile(scene), scene));
  EXPECT_EQ(store.counts().geometries, 0U);
  EXPECT_EQ(store.counts().geometry_misses, 0);
}

TEST(GeometryStore, BytesNeverPassTheLimit) {
  const std::size_t one = bytes_alone(two_bowls(20)), limit = 3 * one;
  GeometryStore store(static_cast<std::int64_t>(limit));
  for (int i = 0; i < 40; ++i) {
    compile_in(store, two_bowls(12 + i % 9, 1 + i));
    ASSERT_LE(store.counts().bytes, limit);
    ASSERT_GE(store.counts().geometries, i == 0 ? 1U : 2U);
    ASSERT_EQ(store.counts().geometries, store.counts().meshes);
  }
}

TEST(GeometryStore, AMeshCountsOnceAndGoesWithItsLastUser) {
  const Scene scene = two_bowls(20);
  const std::size_t one = bytes_alone(scene);
  GeometryStore store(static_cast<std::int64_t>(one + one / 2));
  for (int i = 0; i < 50; ++i) {
    Scene moved = scene;
    moved.objects[0].transform = {{Translate{{0, 0, 0.1 * i}}}};
    compile_in(store, moved);
    ASSERT_EQ(store.counts().mesh_misses, 1);
    ASSERT_EQ(store.counts().meshes, 1U);
    ASSERT_LE(store.counts().bytes, one + one / 2);
  }
  EXPECT_GT(store.counts().geometries, 5U);
  compile_in(store, two_bowls(20, 2));  // another mesh, for which all others must go
  EXPECT_EQ(store.counts().meshes, 1U);
  EXPECT_EQ(store.counts().geometries, 1U);
  EXPECT_EQ(store.counts().bytes, bytes_alone(two_bowls(20, 2)));
}

TEST(GeometryStore, TheOneNotAskedForLongestFallsOutFirst) {
  const Scene a = two_bowls(20, 1), b = two_bowls(20, 2), c = two_bowls(20, 3);
  GeometryStore store(static_cast<std::int64_t>(5 * bytes_alone(a) / 2));
  compile_in(store, a);
  compile_in(store, b);
  compile_in(store, a);  // found: now b is the oldest
  compile_in(store, c);
  EXPECT_EQ(store.counts().geometry_hits, 1);
  compile_in(store, a);
  EXPECT_EQ(store.counts().geometry_hits, 2);
  compile_in(store, b);
  EXPECT_EQ(store.counts().geometry_misses, 4);
}

TEST(GeometryStore, OneThatAloneIsTooMuchIsNotKeptAndPushesNothingOut) {
  const Scene small = two_bowls(4), large = two_bowls(20);
  GeometryStore store(static_cast<std::int64_t>(bytes_alone(large) - 1));
  compile_in(store, small);
  EXPECT_EQ(compiled(store, large).objects, 4);
  EXPECT_EQ(store.counts().geometries, 1U);
  compile_in(store, small);
  EXPECT_EQ(store.counts().geometry_hits, 1);
}

TEST(GeometryStore, WhatFellOutLivesAsLongAsItIsUsed) {
  const Scene scene = two_bowls(20);
  GeometryStore store(static_cast<std::int64_t>(3 * bytes_alone(scene) / 2));
  const World used = compiled(store, scene);
  compile_in(store, two_bowls(20, 2));
  EXPECT_EQ(used.of_objects.use_count(), 1);
  EXPECT_EQ(pixels_of(used, scene), pixels_of(compile(scene), scene));
}

TEST(GeometryStore, ManyThreadsBuildFindAndStopAtOnce) {
  constexpr int threads = 8, each = 60;
  const std::size_t one = bytes_alone(two_bowls(8));
  GeometryStore store(static_cast<std::int64_t>(3 * one));
  std::stop_source stopped;
  stopped.request_stop();
  std::vector<std::thread> running;
  for (int t = 0; t < threads; ++t)
    running.emplace_back([&, t] {
      for (int i = 0; i < each; ++i) {
        Scene scene = two_bowls(8, 1 + (t + i) % 4);
        scene.objects[0].transform = {{Translate{{0, 0, 1.0 * (i % 3)}}}};
        try {
          const World world =
              compiled(store, scene, i % 5 == 0 ? stopped.get_token() : std::stop_token());
          EXPECT_EQ(world.of_objects->meshes.size(), 2U);
          const Points& points = world.of_objects->meshes[0]->positions;
          EXPECT_EQ(points[points.size() - 1].z, 2.0 * (1 + (t + i) % 4));
        } catch (const Stopped&) {
          EXPECT_EQ(i % 5, 0);
        }
        EXPECT_LE(store.counts().bytes, 3 * one);
      }
    });
  for (std::thread& thread : running) thread.join();
  const StoreCounts counts = store.counts();
  EXPECT_EQ(counts.geometry_hits + counts.geometry_misses, threads * each);
  EXPECT_GT(counts.geometry_hits, 0);
  EXPECT_LE(counts.meshes, counts.geometries);
}

}  // namespace
}  // namespace tia::test
