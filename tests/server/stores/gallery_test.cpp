// The gallery: every scene in web/scenes is there, reads, and answers to its keys.
#include <cmath>
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
  EXPECT_EQ(gallery.names().size(), files);
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
  EXPECT_TRUE(gallery.has("thesis"));
  EXPECT_FALSE(gallery.has("thesi"));
  EXPECT_FALSE(gallery.find("thesi"));
  EXPECT_FALSE(gallery.find(""));
}

// GET /scenes names all (Scenes.TheListNamesEverySceneOfTheGallery).
TEST(Gallery, ARequestForAnUnknownNameIsToldTheNearestAndWhereAllAre) {
  const auto all = host().gallery().names().size();
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

// With one sample a pixel a picture is of its own moment alone, whatever the shutter is.
TEST(Gallery, AMomentOfEveryFilmIsThePictureOfItsPlainScene) {
  int films = 0;
  for (const auto& [name, scene] : host().gallery().scenes()) {
    if (!scene->animation && !scene->physics) continue;
    ++films;
    const std::string plain = host().get("/scenes/" + name + "?time=1.375").body;
    const Response told = host().post(
        "/render", R"({"width":24,"height":18,"samples":1,"threshold":0,"scene":)" + plain + "}");
    const Response moment =
        host().get("/render?width=24&height=18&samples=1&threshold=0&time=1.375&scene=" + name);
    EXPECT_EQ(moment.status, 200) << name;
    EXPECT_TRUE(told.body == moment.body) << name;
  }
  EXPECT_GE(films, 9);
}

// The plane through the sun and the style, which points to the pole, cuts the dial in the hour's
// line. Source: Rohr, Sundials (1965), of horizontal dials: tan(line) = sin(latitude) tan(hour
// angle).
TEST(Gallery, TheSundialsShadowIsOnTheHoursLine) {
  const double degree = 3.14159265358979323846 / 180, latitude = 52 * degree;
  const double pole[] = {0, std::sin(latitude), -std::cos(latitude)};
  int lines = 0;
  for (int hour = 5; hour < 19; ++hour) {
    const Value scene =
        parse_json(host().get("/scenes/sundial?time=" + std::to_string(hour - 5)).body);
    const Value& light = at(scene, "lights").as<Value::Array>()->front();
    const double up = number_at(light, "elevation_degrees") * degree;
    const double around = number_at(light, "azimuth_degrees") * degree;
    const double sun[] = {std::sin(around) * std::cos(up), std::sin(up),
                          -std::cos(around) * std::cos(up)};
    EXPECT_GT(sun[1], 0);
    // The shadow of the style's tip, as far along the sun's rays as the dial is below it.
    const double x = -pole[1] / sun[1] * sun[0], z = pole[2] - pole[1] / sun[1] * sun[2];
    const double length = std::hypot(x, z);
    for (const Value& object : *at(scene, "objects").as<Value::Array>()) {
      if (find(*object.as<Value::Object>(), "name") == nullptr ||
          text_at(object, "name") != "hour " + std::to_string(hour))
        continue;
      ++lines;
      const Value::Array& cap = *at(object, "cap").as<Value::Array>();
      const double to_x = *cap[0].as<double>(), to_z = *cap[2].as<double>();
      const double far = std::hypot(to_x, to_z);
      EXPECT_NEAR(x / length, to_x / far, 1e-4) << hour;
      EXPECT_NEAR(z / length, to_z / far, 1e-4) << hour;
    }
  }
  EXPECT_EQ(lines, 14);
}

}  // namespace
}  // namespace tia::test
