// Compiled scenes that pictures share: what is found again and what is built, what falls out when,
// and that no picture shows any of it.
#include "server/geometry_store.h"

#include <cmath>
#include <functional>
#include <thread>

#include "tests/core/accel/worlds.h"
#include "tests/server/support.h"

namespace tia::test {
namespace {

constexpr std::int64_t plenty = 1 << 30;

// A bowl of 2 n^2 triangles.
Mesh bowl(int n, double depth = 1) {
  Mesh mesh;
  for (int i = 0; i <= n; ++i)
    for (int k = 0; k <= n; ++k) {
      const double x = 2.0 * i / n - 1, y = 2.0 * k / n - 1;
      mesh.positions.values.insert(mesh.positions.values.end(), {x, y, depth * (x * x + y * y)});
    }
  const auto at = [&](int i, int k) { return static_cast<std::uint32_t>(i * (n + 1) + k); };
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k)
      mesh.indices.values.insert(
          mesh.indices.values.end(),
          {at(i, k), at(i + 1, k), at(i, k + 1), at(i + 1, k), at(i, k + 1), at(i + 1, k + 1)});
  return mesh;
}
// Two objects of one mesh, a ball and a light.
Scene two_bowls(int n, double depth = 1) {
  Scene scene;
  scene.objects = {object_of(bowl(n, depth)), object_of(bowl(n, depth), {{Translate{{3, 0, 0}}}}),
                   object_of(Sphere{{0, 3, 0}, 1})};
  scene.lights = {sphere_light({0, 9, 9}, 1)};
  return scene;
}
void compile_in(GeometryStore& store, const Scene& scene) {
  static_cast<void>(store.compile(scene, {}));
}

// ---- what is built --------------------------------------------------------------------------

struct Change {
  const char* law;
  std::function<void(Scene&)> make;
};

TEST(GeometryStore, WhatRaysCannotMeetCostsNoBuild) {
  const Change changes[] = {
      {"nothing", [](Scene&) {}},
      {"camera",
       [](Scene& scene) {
         scene.camera.location = {0, 1, 9};
       }},
      {"light moved",
       [](Scene& scene) {
         scene.lights[0] = sphere_light({1, 9, 9}, 2);
       }},
      {"light more",
       [](Scene& scene) {
         scene.lights.push_back(point_light({0, 1, 1}));
       }},
      {"lights gone", [](Scene& scene) { scene.lights.clear(); }},
      {"key light",
       [](Scene& scene) {
         scene.key_light = sphere_light({0, 0, 7}, 1);
       }},
      {"background",
       [](Scene& scene) {
         scene.background = {1, 0, 0};
       }},
      {"options", [](Scene& scene) { scene.options.transparent_shadows = true; }},
      {"title", [](Scene& scene) { scene.title = "other"; }},
  };
  GeometryStore store(plenty);
  const Scene scene = two_bowls(4);
  const SharedGeometry first = store.compile(scene, {}).of_objects;
  std::int64_t hits = 0;
  for (const Change& change : changes) {
    SCOPED_TRACE(change.law);
    Scene changed = scene;
    change.make(changed);
    EXPECT_EQ(store.compile(changed, {}).of_objects, first);
    const StoreCounts counts = store.counts();
    EXPECT_EQ(counts.geometry_hits, ++hits);
    EXPECT_EQ(counts.geometry_misses, 1);
    EXPECT_EQ(counts.mesh_misses, 1);
  }
}

TEST(GeometryStore, WhatRaysMeetIsBuiltAnewButItsMeshes) {
  const Change changes[] = {
      {"object moved",
       [](Scene& scene) {
         scene.objects[0].transform = {{Translate{{0, 1, 0}}}};
       }},
      {"ball moved",
       [](Scene& scene) {
         scene.objects[2].shape = Sphere{{0, 4, 0}, 1};
       }},
      {"objects swapped", [](Scene& scene) { std::swap(scene.objects[0], scene.objects[2]); }},
      {"object gone", [](Scene& scene) { scene.objects.pop_back(); }},
      {"material",
       [](Scene& scene) {
         scene.objects[0].material = matte({1, 0, 0});
       }},
      {"materials",
       [](Scene& scene) {
         scene.materials["a"] = matte({1, 0, 0});
       }},
      {"ambient light",
       [](Scene& scene) {
         scene.ambient_light = {0.5, 0, 0};
       }},
      {"in a group",
       [](Scene& scene) {
         scene.objects = {object_of(Group{scene.objects, {}})};
       }},
      {"in a grid",
       [](Scene& scene) {
         scene.objects = {object_of(Group{scene.objects, Repeat{{2, 1, 1}, {9, 0, 0}}})};
       }},
      {"in a longer grid",
       [](Scene& scene) {
         scene.objects = {object_of(Group{scene.objects, Repeat{{3, 1, 1}, {9, 0, 0}}})};
       }},
  };
  GeometryStore store(plenty);
  const Scene scene = two_bowls(4);
  const SharedGeometry first = store.compile(scene, {}).of_objects;
  EXPECT_EQ(first->meshes[0], first->meshes[1]) << "one mesh, however often it is used";
  std::int64_t misses = 1;
  for (const Change& change : changes) {
    SCOPED_TRACE(change.law);
    Scene changed = scene;
    change.make(changed);
    const SharedGeometry built = store.compile(changed, {}).of_objects;
    EXPECT_NE(built, first);
    for (const SharedMesh& mesh : built->meshes) EXPECT_EQ(mesh, first->meshes[0]);
    const StoreCounts counts = store.counts();
    EXPECT_EQ(counts.geometry_misses, ++misses);
    EXPECT_EQ(counts.geometry_hits, 0);
    EXPECT_EQ(counts.mesh_misses, 1);
    EXPECT_EQ(counts.mesh_hits, misses - 1);
  }
  compile_in(store, two_bowls(4, 2));
  EXPECT_EQ(store.counts().mesh_misses, 2);
}

TEST(GeometryStore, TellsScenesApartByEveryNumberAndKind) {
  // All of one thing each: no two may share a geometry.
  std::vector<Scene> scenes;
  Random random(61);
  for (int i = 0; i < 300; ++i) {
    Scene scene;
    scene.objects = {random_object(random, 1)};
    scenes.push_back(scene);
  }
  Mesh mesh = bowl(2);
  for (int i = 0; i < 3; ++i) {  // numbers that move from one list to the next
    Scene scene;
    scene.objects = {object_of(mesh)};
    scenes.push_back(scene);
    mesh.normals.values.insert(mesh.normals.values.end(), mesh.positions.values.begin(),
                               mesh.positions.values.end());
    std::swap(mesh.normals.values, i == 0 ? mesh.uvs.values : mesh.normals.values);
  }
  std::vector<Digest> digests;
  for (const Scene& scene : scenes) digests.push_back(digest_of_objects(scene).all);
  for (std::size_t i = 0; i < scenes.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) EXPECT_NE(digests[i], digests[k]) << i << ' ' << k;
  for (std::size_t i = 0; i < scenes.size(); ++i)
    EXPECT_EQ(digest_of_objects(Scene(scenes[i])).all, digests[i]);
}

TEST(GeometryStore, StoppedBuildsLeaveNoTrace) {
  GeometryStore store(plenty);
  std::stop_source source;
  source.request_stop();
  EXPECT_THROW(static_cast<void>(store.compile(two_bowls(4), source.get_token())), Stopped);
  EXPECT_EQ(store.counts().geometries, 0U);
  EXPECT_EQ(store.counts().meshes, 0U);
  EXPECT_EQ(store.counts().bytes, 0U);
  EXPECT_EQ(store.compile(two_bowls(4), {}).objects, 4);
}

// ---- pictures -------------------------------------------------------------------------------

// Scenes of everything there is, with luminous lights.
Scene any_scene(std::uint64_t seed) {
  Random random(seed);
  Scene scene = mixed_scene(random, 12, 1);
  scene.camera.location = {0, 2, 25};
  scene.camera.look_at = Vec3d{};
  scene.materials["glow"] = matte({1, 1, 1}, {0.2, 0.4, 0.1});
  scene.objects.push_back(object_of(Sphere{{0, 6, 0}, 1}));
  scene.objects.back().material = "glow";
  QuadLight quad;
  quad.corner = Vec3d{-2, 8, 2};
  quad.u = {2, 0, 0};
  quad.v = {0, 0, 2};
  scene.lights = {sphere_light({5, 5, 9}, 1), point_light({-9, 9, 9}), Light{quad, {1, 1, 1}, 1}};
  return scene;
}

std::vector<float> pixels_of(const World& world, const Scene& scene) {
  constexpr int width = 40, height = 30;
  LinearFilm film(width, height);
  RenderOptions options;
  options.integrator = IntegratorName::whitted;
  options.max_depth = 3;
  render(world, view_of(scene.camera, width, height), {0, 0, width, height}, options, host().pool(),
         {}, [&](const Block& block) { film.put(block); });
  return film.image().rgb;
}

TEST(GeometryStore, NeverShowsInAPicture) {
  GeometryStore store(plenty);
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    Scene scene = any_scene(seed);
    for (int step = 0; step < 3; ++step) {
      EXPECT_EQ(pixels_of(store.compile(scene, {}), scene), pixels_of(compile(scene), scene))
          << seed << ' ' << step;
      if (step == 0) scene.lights[0] = sphere_light({4, 6, 9}, 0.5);
      if (step == 1) scene.objects[0].transform.steps.push_back(Translate{{0.5, 0, 0}});
    }
  }
  EXPECT_EQ(store.counts().geometry_hits, 30);
  EXPECT_EQ(store.counts().geometry_misses, 60);
}

TEST(GeometryStore, PicturesOfALightThatMovesAreCompiledOnce) {
  Host host;
  const std::string first = host.get("/render?width=64&height=48&light=0,9,0").body;
  host.get("/render?width=64&height=48&light=5,9,0");
  host.get("/explain?x=3&y=4&width=64&height=48&key=a");
  EXPECT_EQ(host.get("/render?width=64&height=48&light=0,9,0").body, first);
  const auto metrics = series_of(host.get("/metrics").body);
  EXPECT_EQ(metrics.at(R"(tia_geometry_lookups_total{of="scene",result="hit"})"), 3);
  EXPECT_EQ(metrics.at(R"(tia_geometry_lookups_total{of="scene",result="miss"})"), 1);
  EXPECT_EQ(metrics.at(R"(tia_geometry_lookups_total{of="mesh",result="miss"})"), 0);
  EXPECT_EQ(metrics.at("tia_geometry_bytes"),
            static_cast<double>(host.geometries().counts().bytes));
  EXPECT_EQ(series_of(host.get("/metrics").body), metrics) << "to ask raises no counter";
}

// ---- what is kept ---------------------------------------------------------------------------

std::size_t bytes_alone(const Scene& scene) {
  GeometryStore store(plenty);
  compile_in(store, scene);
  return store.counts().bytes;
}

TEST(GeometryStore, OfNoBytesKeepsAndCountsNothing) {
  GeometryStore store(0);
  const Scene scene = any_scene(1);
  EXPECT_EQ(pixels_of(store.compile(scene, {}), scene), pixels_of(compile(scene), scene));
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
  EXPECT_EQ(store.compile(large, {}).objects, 4);
  EXPECT_EQ(store.counts().geometries, 1U);
  compile_in(store, small);
  EXPECT_EQ(store.counts().geometry_hits, 1);
}

TEST(GeometryStore, WhatFellOutLivesAsLongAsItIsUsed) {
  const Scene scene = two_bowls(20);
  GeometryStore store(static_cast<std::int64_t>(3 * bytes_alone(scene) / 2));
  const World used = store.compile(scene, {});
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
              store.compile(scene, i % 5 == 0 ? stopped.get_token() : std::stop_token());
          EXPECT_EQ(world.of_objects->meshes.size(), 2U);
          EXPECT_EQ(world.of_objects->meshes[0]->positions.back().z, 2.0 * (1 + (t + i) % 4));
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
