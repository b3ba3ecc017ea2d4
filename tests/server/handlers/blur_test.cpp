// Motion blur over HTTP: shutter and blur_steps, their recipes, what /explain tells.
#include "tests/core/film/exr_reader.h"
#include "tests/server/picture_support.h"
#include "tests/server/support.h"

namespace tia::test {
namespace {

using testing::HasSubstr;

// Lights that come and go and swell over a wall that all of the picture shows, as matt everywhere;
// a ball goes past before it until 1.5 s.
const std::string lit_wall = R"({"animation":{"duration":4,"fps":2,"shutter":0.5,"tracks":[
    {"target":"/lights/0/intensity","formula":"(1+t*t)/4"},
    {"target":"/lights/1","visible":[[1,2.0625]]},
    {"target":"/options/exposure","keys":[[0,0],[4,2]]},
    {"target":"/objects/ball/center","keys":[[0,[-9,0,-5]],[1.25,[0,0,-5]],[1.5,[0,20,-5]]]}]},
  "camera":{"projection":"orthographic","height":6},
  "lights":[{"type":"directional","direction":[0,0,-1]},
            {"type":"directional","direction":[0,-1,-1],"color":[1,0.5,0]}],
  "objects":[{"type":"box","min":[-99,-99,-9],"max":[99,99,-8]},
             {"name":"ball","type":"sphere","center":[0,20,-5],"radius":1,
              "material":{"color":[1,0,0]}}]})";

std::string kept_id(Host& keeper, const std::string& scene) {
  return text_at(parse_json(keeper.post("/scenes", scene).body), "id");
}
std::string without_shutter(std::string scene) {
  return scene.replace(scene.find(R"("shutter":0.5,)"), 14, "");
}
Response blurred(Host& at, const std::string& query) {
  Response response = at.get("/render?width=12&height=9&" + query);
  EXPECT_EQ(response.status, 200) << response.body;
  return response;
}

// All of a pixel's samples of a time see the same light: the picture is the stills' mean, but for
// the rounding of floats.
TEST(MotionBlur, IsTheMeanOfStillsOfTheMiddlesOfItsStrata) {
  Host keeper;
  const std::string id = kept_id(keeper, lit_wall);
  for (const int steps : {1, 2, 5, 8}) {
    const std::string of_all = "format=pfm&samples=" + std::to_string(steps * 2) + "&scene=" + id;
    const auto blur =
        decode_pfm(blurred(keeper, of_all + "&time=2&blur_steps=" + std::to_string(steps)).body);
    std::vector<double> mean(blur.rgb.size());
    for (int i = 0; i < steps; ++i) {
      const double time = 2 + 0.5 / 2 * ((i + 0.5) / steps - 0.5);
      const auto still =
          decode_pfm(blurred(keeper, of_all + "&blur_steps=1&time=" + to_json(Value(time))).body);
      for (std::size_t k = 0; k < mean.size(); ++k)
        mean[k] += static_cast<double>(still.rgb[k]) / steps;
    }
    for (std::size_t k = 0; k < mean.size(); ++k)
      EXPECT_NEAR(static_cast<double>(blur.rgb[k]), mean[k], 2e-7) << steps << " steps";
  }
}

// Another host draws the recipe's request, and the picture sent back, to the same bytes.
TEST(MotionBlur, IsDrawnAgainFromItsRecipe) {
  Host keeper, other;
  const std::string scene = "scene=" + kept_id(keeper, lit_wall);
  for (const char* query :
       {"&samples=16&time=1", "&samples=16&frame=2&integrator=path&exposure=1",
        "&samples=4&time=0.5&blur_steps=3&denoise=true&integrator=ambient_occlusion",
        "&threshold=0.1&frame=3&light=1,2,3", "&samples=16&time=0"}) {
    SCOPED_TRACE(query);
    const Response drawn = blurred(keeper, scene + query);
    const Response again = other.post("/render", drawn.body, "image/png");
    ASSERT_EQ(again.status, 200) << again.body;
    EXPECT_TRUE(again.body == drawn.body);
    EXPECT_EQ(header(again, "ETag"), header(drawn, "ETag"));
    EXPECT_THAT(other.post("/verify", drawn.body, "image/png").body, HasSubstr(R"("same")"));
  }
}

TEST(MotionBlur, IsNamedByWhatItIsOf) {
  Host keeper;
  const std::string scene = "samples=16&time=1&scene=" + kept_id(keeper, lit_wall);
  const auto tag = header(blurred(keeper, scene), "ETag");
  EXPECT_EQ(header(blurred(keeper, scene + "&blur_steps=8"), "ETag"), tag);
  EXPECT_NE(header(blurred(keeper, scene + "&blur_steps=4"), "ETag"), tag);
  EXPECT_NE(header(blurred(keeper,
                           "samples=16&time=1&scene=" + kept_id(keeper, without_shutter(lit_wall))),
                   "ETag"),
            tag);
}

// A frame in which nothing moves, or that has one sample, is the plain scene's.
TEST(MotionBlur, WithoutMotionIsThePlainScenesPicture) {
  Host keeper;
  const std::string still = R"({"animation":{"duration":4,"fps":2,"shutter":1,"tracks":[
      {"target":"/objects/0/radius","keys":[[1,1],[2,2]]},
      {"target":"/title","keys":[[0,"a"],[3.1,"b"]],"interpolation":"step"}]},
    "objects":[{"type":"sphere","center":[0,0,-9],"radius":1}]})";
  std::string open = still;
  open.replace(open.find(R"("shutter":1,)"), 12, "");
  const std::string with = "&scene=" + kept_id(keeper, still);
  const std::string without = "&scene=" + kept_id(keeper, open);
  for (const char* query : {"samples=8&time=3", "samples=8&time=0.5", "samples=1&time=1.5"}) {
    const Response blur = blurred(keeper, query + with), plain = blurred(keeper, query + without);
    EXPECT_TRUE(blur.body == plain.body) << query;
    EXPECT_EQ(header(blur, "ETag"), header(plain, "ETag"));
  }
  EXPECT_FALSE(blurred(keeper, "samples=8&time=1.5" + with).body ==
               blurred(keeper, "samples=8&time=1.5" + without).body);
}

// Numbers that cannot be averaged are of the frame's own time, as pictures and as layers.
TEST(MotionBlur, NumbersOfObjectsAreOfTheFramesOwnTime) {
  Host keeper;
  const std::string moving = kept_id(keeper, lit_wall);
  const std::string plain = kept_id(keeper, without_shutter(lit_wall));
  const std::string query = "integrator=object&time=1.25&scene=";
  EXPECT_TRUE(blurred(keeper, query + moving).body == blurred(keeper, query + plain).body);
  const auto layers = [&](const std::string& id) {
    return read_exr(
        blurred(keeper, "format=exr&aov=object,albedo&samples=8&time=1.25&scene=" + id).body);
  };
  const ExrFile blur = layers(moving), sharp = layers(plain);
  EXPECT_EQ(blur.numbers.at("object"), sharp.numbers.at("object"));
  EXPECT_NE(blur.numbers.at("albedo.G"), sharp.numbers.at("albedo.G"));
}

// ---- /explain -----------------------------------------------------------------------------------

Value told(Host& at, const std::string& query) {
  const Response response = at.get("/explain?width=12&height=9&" + query);
  EXPECT_EQ(response.status, 200) << response.body;
  return parse_json(response.body);
}
double green(const Value& color) { return *(*color.as<Value::Array>())[1].as<double>(); }

TEST(MotionBlur, IsExplainedSampleBySample) {
  Host keeper;
  const std::string scene = "samples=10&blur_steps=4&time=1.25&scene=" + kept_id(keeper, lit_wall);
  for (const int x : {2, 6}) {
    const int y = 3;
    const std::string at_pixel =
        scene + "&x=" + std::to_string(x) + "&y=" + std::to_string(y) + "&integrator=";
    const auto pixel = [&](const std::string& integrator) {
      const auto image =
          decode_pfm(blurred(keeper, "format=pfm&integrator=" + integrator + "&" + scene).body);
      return image.at(x, y, 1);
    };
    double sum = 0;
    for (int s = 0; s < 10; ++s)
      sum += green(
          at(at(told(keeper, at_pixel + "whitted&sample=" + std::to_string(s)), "tree"), "color"));
    EXPECT_EQ(static_cast<float>(sum / 10), pixel("whitted"));
    const Value paths = told(keeper, at_pixel + "path");
    double mean = 0;
    for (const Value& each : *at(paths, "samples").as<Value::Array>())
      mean += green(at(each, "color"));
    EXPECT_EQ(static_cast<float>(mean / 10), pixel("path"));
    EXPECT_EQ(static_cast<float>(green(at(paths, "mean"))), pixel("path"));
  }
}

TEST(MotionBlur, ARayOfItsOwnIsExplainedAtTheFramesTime) {
  Host keeper;
  const std::string ray = "&samples=8&time=1.25&ray.origin=0,0,0&ray.direction=0,0,-1&scene=";
  EXPECT_EQ(
      keeper.get("/explain?" + ray.substr(1) + kept_id(keeper, lit_wall)).body,
      keeper.get("/explain?" + ray.substr(1) + kept_id(keeper, without_shutter(lit_wall))).body);
}

// ---- what is refused ----------------------------------------------------------------------------

TEST(MotionBlur, FaultsAreNamed) {
  Host keeper;
  const std::string id = kept_id(keeper, lit_wall);
  struct Refused {
    std::string query, type, pointer, allowed;
  };
  for (const auto& [query, type, pointer, allowed] : {
           Refused{"blur_steps=2", "conflict", "/blur_steps", "has a shutter"},
           Refused{"blur_steps=0&scene=" + id, "out-of-range", "/blur_steps", "from 1 to 256"},
           Refused{"blur_steps=257&scene=" + id, "out-of-range", "/blur_steps", "from 1 to 256"},
           Refused{"blur_steps=2&scene=" + id, "conflict", "/blur_steps", "which are 1"},
           Refused{"blur_steps=9&samples=8&scene=" + id, "conflict", "/blur_steps", "which are 8"},
           Refused{"blur_steps=2&integrator=object&samples=8&scene=" + id, "conflict",
                   "/blur_steps", "which are 1"},
       })
    for (const char* route : {"/render?", "/explain?x=1&y=1&"}) {
      if (std::string(route) != "/render?" && query.find("object") != query.npos) continue;
      const Response response = keeper.get(route + query);
      EXPECT_EQ(response.status, 422) << query;
      EXPECT_EQ(problem_of(response).type, "/problems/" + type) << query;
      EXPECT_EQ(only_error(response).pointer, pointer);
      EXPECT_THAT(only_error(response).allowed, HasSubstr(allowed));
    }
  const auto error_of = [](const std::string& scene) {
    return only_error(host().post("/scenes", scene));
  };
  EXPECT_EQ(error_of(R"({"animation":{"duration":1,"shutter":-0.1}})").pointer,
            "/animation/shutter");
  EXPECT_THAT(error_of(R"({"animation":{"duration":1,"shutter":1.5}})").allowed,
              HasSubstr("from 0 to 1"));
  const ProblemError error = error_of(R"({"options":{"blur_steps":9,"samples":8}})");
  EXPECT_EQ(error.pointer, "/options/blur_steps");
  EXPECT_THAT(error.allowed, HasSubstr("which are 8"));
}

// A value that the scene cannot have, or none, at a time while the shutter is open.
TEST(MotionBlur, FaultsOfItsTimesAreTold) {
  const Response drawn = host().post("/render", R"({"time":1.5,"samples":4,"scene":{
      "animation":{"duration":4,"fps":1,"shutter":1,"tracks":[
        {"target":"/objects/0/radius","formula":"1.75-t"}]},
      "objects":[{"type":"sphere","center":[0,0,-9],"radius":1}]}})");
  EXPECT_EQ(drawn.status, 422);
  EXPECT_EQ(only_error(drawn).pointer, "/scene/animation/tracks/0");
  EXPECT_THAT(only_error(drawn).allowed, HasSubstr("at 1.875 s at /objects/0/radius"));
}

TEST(MotionBlur, PathsAreNotToldWhereObjectsComeOrGo) {
  Host keeper;
  const std::string id = kept_id(keeper, R"({"animation":{"duration":2,"shutter":1,"tracks":[
      {"target":"/objects/0","visible":[[1,2]]}]},"options":{"integrator":"path"},
    "objects":[{"type":"sphere","center":[0,0,-9],"radius":1}]})");
  const std::string query = "/explain?x=320&y=240&time=1&scene=" + id;
  EXPECT_EQ(only_error(keeper.get(query)).pointer, "/blur_steps");
  EXPECT_EQ(keeper.get(query + "&blur_steps=1").status, 200);
}

}  // namespace
}  // namespace tia::test
