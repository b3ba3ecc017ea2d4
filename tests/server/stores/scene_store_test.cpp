// Kept scenes: their ids, what falls out when, and how much memory they may hold.
#include "server/stores/scene_store.h"

#if defined(__GLIBC__)
#include <malloc.h>
#endif

#include <thread>

#include "core/scene/read_scene.h"
#include "server/operation/config.h"
#include "server/stores/digest.h"
#include "server/stores/scene_bytes.h"
#include "tests/server/support.h"

namespace tia::test {
namespace {

constexpr std::int64_t plenty = 1 << 30;

Scene titled(const std::string& title) {
  Scene scene;
  scene.title = title;
  return scene;
}
// A scene of a mesh whose indices are as many triangles.
Scene meshed(std::size_t triangles) {
  std::string text =
      R"({"objects":[{"type":"mesh","positions":[0,0,0,1,0,0,0,1,0],"indices":[0,1,2)";
  for (std::size_t i = 1; i < triangles; ++i) text += ",0,1,2";
  return read_scene(text + "]}]}");
}

TEST(SceneStore, AnIdIsTheSha256OfTheCanonicalText) {
  SceneStore store(plenty);
  const Scene scene = titled("a");
  const std::string id = store.keep(scene);
  EXPECT_EQ(id, sha256_hex(R"({"title":"a"})"));
  ASSERT_TRUE(store.find(id));
  EXPECT_EQ(*store.find(id), scene);
}

TEST(SceneStore, ASceneSpelledInTwoWaysIsKeptOnce) {
  SceneStore store(plenty);
  const std::string id = store.keep(read_scene(R"({"title":"x","background":[1,1,1]})"));
  const std::size_t bytes = store.bytes();
  EXPECT_EQ(store.keep(read_scene(R"({"background": 1e0, "lights": [], "title": "\u0078"})")), id);
  EXPECT_EQ(store.count(), 1U);
  EXPECT_EQ(store.bytes(), bytes);
}

TEST(SceneStore, AHundredThousandBallsFitTheDefaults) {
  std::vector<Object> balls(100'000);  // as many as there are: so they are read
  for (std::size_t i = 0; i < balls.size(); ++i)
    balls[i].shape = Sphere{{0, 0, -static_cast<double>(i)}, 0.5};
  Scene scene;
  scene.objects = std::move(balls);
  EXPECT_LE(bytes_of(scene), std::size_t{40} << 20);
  SceneStore store(server::Config{}.max_scenes_bytes);
  EXPECT_TRUE(store.find(store.keep(std::move(scene))));
}

TEST(SceneStore, WhatIsNotKeptIsNotFound) {
  SceneStore store(plenty);
  EXPECT_FALSE(store.find(""));
  EXPECT_FALSE(store.find(sha256_hex("")));
}

TEST(SceneStore, TheOneNotAskedForLongestFallsOutFirst) {
  SceneStore store(plenty, 3);
  const std::string a = store.keep(titled("a")), b = store.keep(titled("b")),
                    c = store.keep(titled("c"));
  EXPECT_TRUE(store.find(a));             // now b is the oldest
  EXPECT_EQ(store.keep(titled("b")), b);  // now c is
  const std::string d = store.keep(titled("d"));
  EXPECT_EQ(store.count(), 3U);
  EXPECT_FALSE(store.find(c));
  for (const std::string& id : {a, b, d}) EXPECT_TRUE(store.find(id));
}

TEST(SceneStore, BytesNeverPassTheLimitAndComeBack) {
  const std::size_t one = bytes_of(meshed(1000));
  SceneStore store(static_cast<std::int64_t>(5 * one));
  std::vector<std::string> ids;
  for (std::size_t i = 0; i < 40; ++i) {
    ids.push_back(store.keep(meshed(1 + 997 * i % 1800)));
    ASSERT_LE(store.bytes(), 5 * one);
    ASSERT_TRUE(store.find(ids.back()));
  }
  // Those that are still there are the last ones, and their charge is the store's.
  std::size_t found = 0, bytes = 0;
  for (const std::string& id : ids) {
    const KnownScene scene = store.find(id);
    EXPECT_TRUE(scene || found == 0) << "an older one outlived a newer one";
    if (!scene) continue;
    ++found;
    bytes += bytes_of(*scene);
  }
  EXPECT_EQ(store.count(), found);
  EXPECT_GT(found, 3U);
  EXPECT_GE(store.bytes(), bytes);
  EXPECT_LT(store.bytes(), bytes + 1000 * found);
}

TEST(SceneStore, ASceneThatAloneIsTooMuchIsRefusedAndPushesNothingOut) {
  const auto limit = static_cast<std::int64_t>(bytes_of(meshed(100)));
  SceneStore store(limit);
  const std::string small = store.keep(titled("small"));
  try {
    store.keep(meshed(200));
    FAIL() << "kept";
  } catch (const InputError& error) {
    ASSERT_EQ(error.faults().size(), 1U);
    EXPECT_EQ(error.faults().front().kind, FaultKind::limit);
    EXPECT_THAT(error.what(), testing::HasSubstr(std::to_string(limit)));
    EXPECT_THAT(error.what(), testing::HasSubstr("TIA_MAX_SCENES_BYTES"));
  }
  EXPECT_TRUE(store.find(small));
}

TEST(SceneStore, ASceneThatFellOutLivesAsLongAsItIsUsed) {
  SceneStore store(plenty, 1);
  const KnownScene used = store.find(store.keep(titled("used")));
  store.keep(titled("other"));
  EXPECT_FALSE(store.find(sha256_hex(canonical_text(*used))));
  EXPECT_EQ(used->title, "used");
  EXPECT_EQ(used.scene.use_count(), 1);
}

TEST(SceneStore, ManyThreadsKeepAndFindAtOnce) {
  constexpr int threads = 8, each = 60;
  SceneStore store(plenty, 10);
  std::vector<std::thread> running;
  for (int t = 0; t < threads; ++t)
    running.emplace_back([&store, t] {
      for (int i = 0; i < each; ++i) {
        const Scene scene = titled(std::to_string((t + i) % 25));
        const KnownScene found = store.find(store.keep(scene));
        EXPECT_TRUE(!found || *found == scene);  // another may have pushed it out
        EXPECT_LE(store.count(), 10U);
      }
    });
  for (std::thread& thread : running) thread.join();
  EXPECT_EQ(store.count(), 10U);
}

// ---- what a scene holds ------------------------------------------------------------------------

struct Heavy {
  const char* law;
  std::string text;
};
std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += (i > 0 ? "," : "") + text;
  return all;
}
std::vector<Heavy> heavy_scenes() {
  const std::string sphere = R"({"type":"sphere","center":[0,0,0],"radius":1})";
  std::string materials;
  for (int i = 0; i < 2000; ++i) materials += (i > 0 ? ",\"" : "\"") + std::to_string(i) + "\":{}";
  return {
      {"Objects", R"({"objects":[)" + repeated(sphere, 3000) + "]}"},
      {"Children", R"({"objects":[{"type":"group","children":[)" + repeated(sphere, 3000) + "]}]}"},
      {"Steps", R"({"objects":[{"type":"sphere","center":[0,0,0],"radius":1,"transform":[)" +
                    repeated(R"({"translate":[1,2,3]})", 3000) + "]}]}"},
      {"Numbers", R"({"keys":{"a":{"nothing":[)" + repeated("1", 100'000) + "]}}}"},
      {"Materials", R"({"materials":{)" + materials + "}}"},
      {"Lights",
       R"({"lights":[)" + repeated(R"({"type":"point","position":[0,1,0]})", 3000) + "]}"},
      {"Title", R"({"title":")" + std::string(300'000, 'x') + "\"}"},
      {"Mesh", canonical_text(meshed(30'000))}};
}

#if defined(__GLIBC__)
std::size_t in_use() {
  const struct mallinfo2 heap = mallinfo2();
  return heap.uordblks + heap.hblkhd;
}

TEST(SceneBytes, AreWhatTheAllocatorHasGiven) {
  if (sanitized()) GTEST_SKIP() << "has an allocator of its own";
  for (const Heavy& each : heavy_scenes()) {
    SCOPED_TRACE(each.law);
    const std::size_t before = in_use();
    const auto scene = std::make_unique<Scene>(read_scene(each.text));
    const auto taken = static_cast<double>(in_use() - before);
    EXPECT_GT(taken, 200'000);
    EXPECT_NEAR(static_cast<double>(bytes_of(*scene)) / taken, 1, 0.1);
  }
}
#endif

TEST(SceneBytes, CountWhatEachElementMustHold) {
  const std::size_t empty = bytes_of(Scene{});
  const std::size_t least[] = {3000 * sizeof(Object),
                               3000 * sizeof(Object),
                               3000 * sizeof(TransformSteps::Step),
                               100'000 * sizeof(Value),
                               2000 * sizeof(Material),
                               3000 * sizeof(Light),
                               300'000,
                               90'000 * sizeof(std::uint32_t)};
  const std::vector<Heavy> scenes = heavy_scenes();
  for (std::size_t i = 0; i < scenes.size(); ++i)
    EXPECT_GT(bytes_of(read_scene(scenes[i].text)), empty + least[i]) << scenes[i].law;
}

}  // namespace
}  // namespace tia::test
