// The gallery: every scene in web/scenes is there, reads, and answers to its keys.
#include <filesystem>

#include "core/scene/keys.h"
#include "core/scene/read_scene.h"
#include "tests/server/support.h"

namespace tia::test {
namespace {

TEST(Gallery, HoldsEverySceneOfWebScenes) {
  const Gallery gallery;
  std::size_t files = 0;
  const std::string folder = std::string(TIA_SOURCE_DIR) + "/web/scenes";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".json") continue;
    ++files;
    const KnownScene scene = gallery.find(entry.path().stem().string());
    ASSERT_TRUE(scene) << entry.path();
    EXPECT_EQ(*scene, read_scene(file_bytes(entry.path().string())));
    EXPECT_FALSE(scene->title.empty());
    EXPECT_FALSE(scene->description.empty());
  }
  EXPECT_EQ(gallery.scenes().size(), files);
}

TEST(Gallery, EverySceneIsDrawnUnderEachOfItsKeys) {
  for (const auto& [name, scene] : host().gallery().scenes()) {
    std::string picture = "/render?width=16&height=12&scene=" + url_encode(name);
    if (sanitized()) picture += "&samples=1&threshold=0";
    EXPECT_EQ(host().get(picture).status, 200) << name;
    for (const std::string_view key : keys_of(*scene))
      EXPECT_EQ(host().get(picture + "&key=" + url_encode(key)).status, 200) << name << " " << key;
  }
}

TEST(Gallery, AnUnknownNameIsNone) {
  const Gallery gallery;
  EXPECT_FALSE(gallery.find("thesi"));
  EXPECT_FALSE(gallery.find(""));
}

// GET /scenes names all (Scenes.TheListNamesEverySceneOfTheGallery).
TEST(Gallery, ARequestForAnUnknownNameIsToldTheNearestAndWhereAllAre) {
  const auto all = host().gallery().scenes().size();
  const std::string told = "thesis, ", more = " and " + std::to_string(all - 8) + " more";
  const ProblemError error = only_error(host().get("/render?scene=thesi"));
  EXPECT_EQ(error.pointer, "/scene");
  EXPECT_EQ(error.nearest, "thesis");
  EXPECT_THAT(error.allowed, testing::StartsWith("a scene's name (" + told));
  EXPECT_THAT(error.allowed, testing::HasSubstr(more + "; GET /scenes has all)"));
  const std::string detail = problem_of(host().get("/scenes/thesi")).detail;
  EXPECT_THAT(detail, testing::HasSubstr("there are: " + told));
  EXPECT_THAT(detail, testing::HasSubstr(more + " in GET /scenes"));
}

}  // namespace
}  // namespace tia::test
