// Compiled scenes that pictures share: what is found again and what is built,
// and that no picture shows any of it.
#include "server/stores/geometry_store.h"

#include <functional>

#include "tests/server/stores/geometry_support.h"

namespace tia::test {
namespace {

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
  const SharedGeometry first = compiled(store, scene).of_objects;
  std::int64_t hits = 0;
  for (const Change& change : changes) {
    SCOPED_TRACE(change.law);
    Scene changed = scene;
    change.make(changed);
    EXPECT_EQ(compiled(store, changed).of_objects, first);
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
  const SharedGeometry first = compiled(store, scene).of_objects;
  EXPECT_EQ(first->meshes[0], first->meshes[1]) << "one mesh, however often it is used";
  std::int64_t misses = 1;
  for (const Change& change : changes) {
    SCOPED_TRACE(change.law);
    Scene changed = scene;
    change.make(changed);
    const SharedGeometry built = compiled(store, changed).of_objects;
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

TEST(GeometryStore, StoppedBuildsLeaveNoTrace) {
  GeometryStore store(plenty);
  std::stop_source source;
  source.request_stop();
  EXPECT_THROW(static_cast<void>(compiled(store, two_bowls(4), source.get_token())), Stopped);
  EXPECT_EQ(store.counts().geometries, 0U);
  EXPECT_EQ(store.counts().meshes, 0U);
  EXPECT_EQ(store.counts().bytes, 0U);
  EXPECT_EQ(compiled(store, two_bowls(4)).objects, 4);
}

// ---- pictures -------------------------------------------------------------------------------

TEST(GeometryStore, NeverShowsInAPicture) {
  GeometryStore store(plenty);
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    Scene scene = any_scene(seed);
    for (int step = 0; step < 3; ++step) {
      EXPECT_EQ(pixels_of(compiled(store, scene), scene), pixels_of(compile(scene), scene))
          << seed << ' ' << step;
      if (step == 0) scene.lights[0] = sphere_light({4, 6, 9}, 0.5);
      if (step == 1) scene.objects[0].transform.steps.push_back(Translate{{0.5, 0, 0}});
    }
  }
  EXPECT_EQ(store.counts().geometry_hits, 30);
  EXPECT_EQ(store.counts().geometry_misses, 60);
}

TEST(GeometryStore, PicturesOfALightThatMovesAreCompiledOnce) {
  Config config;
  config.cache_bytes = 0;
  Host host(config);
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

// A scene that is kept brings its digest along: a key that changes objects must not.
TEST(GeometryStore, AKeyThatPatchesObjectsShowsThem) {
  Host host;
  const auto scene = [](const char* radius) {
    return std::string(R"({"objects":[{"type":"sphere","center":[0,0,-9],"radius":)") + radius +
           R"(}],"background":[1,1,1],"keys":{"b":{"objects":[)" +
           R"({"type":"sphere","center":[0,0,-9],"radius":2}]},"l":{"light":[0,9,0]}}})";
  };
  const std::string view = "/render?width=32&height=24&scene=";
  const auto kept = [&](const char* radius) {
    return view + text_at(parse_json(host.post("/scenes", scene(radius)).body), "id");
  };
  const std::string small = kept("1"), large = kept("2");
  const std::string picture = host.get(small).body;
  EXPECT_EQ(host.get(small + "&key=b").body, host.get(large).body);
  EXPECT_EQ(host.get(small).body, picture);
  const StoreCounts before = host.geometries().counts();
  EXPECT_NE(host.get(small + "&key=l").body, picture);
  const StoreCounts after = host.geometries().counts();
  EXPECT_EQ(after.geometry_hits, before.geometry_hits + 1);
  EXPECT_EQ(after.geometry_misses, before.geometry_misses);
}

}  // namespace
}  // namespace tia::test
