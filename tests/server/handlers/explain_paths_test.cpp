// /explain of path: the paths of a pixel's light, and their groups.
#include <algorithm>
#include <set>

#include "tests/server/handlers/explain_support.h"
#include "tests/server/picture_support.h"

namespace tia::test {
namespace {

const Value::Array& list_at(const Value& value, const char* name) {
  return *at(value, name).as<Value::Array>();
}

// A floor with lamps that are points, areas and endless, in an order of their own.
const char* const lit_floor = R"({"objects":[
    {"type":"plane","name":"floor","point":[0,0,0],"normal":[0,1,0]},
    {"type":"sphere","name":"glow","center":[0,3,-9],"radius":0.5,
     "material":{"emission":[4,4,4]}}],
  "lights":[
    {"type":"directional","direction":[1,-3,0]},
    {"type":"point","position":[0,5,-9],"intensity":40},
    {"type":"quad","corner":[4,5,-9],"u":[1,0,0],"v":[0,0,1],"intensity":40},
    {"type":"point","position":[-6,5,-9],"intensity":40},
    {"type":"directional","direction":[-1,-1,0]}],
  "camera":{"location":[0,2,0],"look_at":[0,0,-9]},"background":[0.1,0.2,0.3]})";

TEST(ExplainPath, ThePixelOfThePictureIsTheMean) {
  const char* const query = "scene=room&integrator=path&samples=8&threshold=0&width=32&height=24";
  const auto image = decode_pfm(host().get(std::string("/render?format=pfm&").append(query)).body);
  double most_over = 0;
  for (const auto& [x, y] : {std::pair{3, 20}, std::pair{16, 12}, std::pair{30, 2}}) {
    const Response response = host().get("/explain?" + std::string(query) +
                                         "&x=" + std::to_string(x) + "&y=" + std::to_string(y));
    ASSERT_EQ(response.status, 200) << response.body;
    const Value answer = parse_json(response.body);
    const Vec3d mean = vec(at(answer, "mean"));
    expect_near(mean, {image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)}, 0);
    EXPECT_EQ(number_at(answer, "count"), 8);
    Vec3d by_paths{}, by_groups{};
    for (const Value& each : list_at(answer, "samples"))
      by_paths = by_paths + vec(at(each, "color")) * (1.0 / 8);
    for (const Value& each : list_at(answer, "groups"))
      by_groups = by_groups + vec(at(each, "mean"));
    double over = 0;
    for (const Value& each : list_at(answer, "over")) {
      const int id = static_cast<int>(number_at(each, "id"));
      EXPECT_TRUE(std::ranges::any_of(list_at(answer, "objects"), [&](const Value& listed) {
        return number_at(listed, "id") == id && at(listed, "name") == at(each, "object");
      }));
      over += number_at(each, "share");
    }
    most_over = std::max(most_over, over);
    double longer = 0;
    for (const Value& each : list_at(answer, "groups"))
      if (text_at(each, "expression").size() > 2 || text_at(each, "expression")[0] == '*')
        longer += number_at(each, "share");
    EXPECT_LE(over, longer + 1e-6);
    expect_near(by_paths, mean, 1e-6);
    expect_near(by_groups, mean, 1e-6);
  }
  EXPECT_GT(most_over, 0.01);
}

// Where a light is, by its name.
void expect_from_there(const Value& light) {
  const std::string name = text_at(light, "light");
  const Vec3d p = vec(at(light, "point")), wi = vec(at(light, "direction"));
  const auto expect_towards = [&](const Vec3d& place, double within) {
    expect_near(wi, normalize(place - p), within);
  };
  if (name == "/lights/0") expect_near(wi, normalize(Vec3d{-1, 3, 0}), 1e-5);
  else if (name == "/lights/1") expect_towards({0, 5, -9}, 1e-5);
  else if (name == "/lights/2") expect_towards({4.5, 5, -8.5}, 0.2);
  else if (name == "/lights/3") expect_towards({-6, 5, -9}, 1e-5);
  else if (name == "/lights/4") expect_near(wi, normalize(Vec3d{1, 1, 0}), 1e-5);
  else if (name == "glow") expect_towards({0, 3, -9}, 0.2);
  else FAIL() << name;
}

TEST(ExplainPath, LightsAreCalledWhatTheyAre) {
  const Value answer = answer_to({{"scene", parse_json(lit_floor)},
                                  {"integrator", "path"},
                                  {"x", 320},
                                  {"y", 300},
                                  {"samples", 64},
                                  {"paths", 64}});
  std::set<std::string> asked, met;
  for (const Value& sample : list_at(answer, "samples"))
    for (const Value& vertex : list_at(sample, "vertices"))
      for (const Value& light : list_at(vertex, "lights")) {
        const bool was_asked = *at(light, "asked").as<bool>();
        (was_asked ? asked : met).insert(text_at(light, "light"));
        if (was_asked) expect_from_there(light);
      }
  EXPECT_EQ(asked.size(), 6U);
  EXPECT_TRUE(met.contains("/background"));
  EXPECT_EQ(text_at(list_at(list_at(answer, "samples")[0], "vertices")[0], "object"), "floor");
  EXPECT_EQ(at(answer, "pixel"), Value(Value::Array{320, 300}));
  EXPECT_FALSE(hits_of(answer).empty());
}

TEST(ExplainPath, TellsAsManyPathsAsAskedFor) {
  const auto told = [](const Value::Object& more) {
    Value::Object asked{
        {"scene", parse_json(lit_floor)}, {"integrator", "path"}, {"x", 9}, {"y", 9}};
    asked.insert(asked.end(), more.begin(), more.end());
    const Value answer = answer_to(asked);
    std::vector<double> samples;
    for (const Value& each : list_at(answer, "samples"))
      samples.push_back(number_at(each, "sample"));
    EXPECT_EQ(number_at(answer, "count"), 64);
    return samples;
  };
  EXPECT_EQ(told({}).size(), 16U);
  EXPECT_EQ(told({{"paths", 0}}).size(), 0U);
  EXPECT_EQ(told({{"paths", 3}, {"sample", 5}}), (std::vector<double>{5, 6, 7}));
  EXPECT_EQ(told({{"paths", 9}, {"sample", 62}}), (std::vector<double>{62, 63}));
}

TEST(ExplainPath, OfARayIsWhatComesAlongIt) {
  const Value answer = answer_to(
      {{"scene", parse_json(R"({"background":[1,2,3]})")},
       {"integrator", "path"},
       {"samples", 1},
       {"ray", Value::Object{{"origin", array({0, 0, 0})}, {"direction", array({0, 0, -2})}}}});
  expect_near(vec(at(answer, "mean")), {1, 2, 3}, 0);
  const Value& only = list_at(answer, "groups").at(0);
  EXPECT_EQ(text_at(only, "expression"), "E");
  EXPECT_EQ(number_at(only, "share"), 1);
  EXPECT_EQ(find(*only.as<Value::Object>(), "error"), nullptr) << "of one there is none";
  EXPECT_EQ(text_at(list_at(answer, "samples").at(0), "end"), "left");
}

TEST(ExplainPath, FaultsAreNamed) {
  struct Refused {
    const char *query, *type, *pointer, *allowed;
  };
  for (const Refused& fault : {
           Refused{"paths=3", "conflict", "/paths", "the integrator path"},
           Refused{"integrator=whitted&paths=3", "conflict", "/paths", "whitted are a tree"},
           Refused{"integrator=path&paths=1025", "out-of-range", "/paths", "from 0 to 1024"},
           Refused{"integrator=path&paths=-1", "out-of-range", "/paths", "from 0 to 1024"},
           Refused{"integrator=path&sample=64", "out-of-range", "/sample", "from 0 to 63"},
           Refused{"integrator=path&samples=8&threshold=0.1&sample=8", "out-of-range", "/sample",
                   "from 0 to 7"},
           Refused{"integrator=ambient_occlusion", "out-of-range", "/integrator",
                   "thesis or whitted or path"},
       }) {
    SCOPED_TRACE(fault.query);
    const Response response = host().get("/explain?x=1&y=1&" + std::string(fault.query));
    EXPECT_EQ(problem_of(response).type, std::string("/problems/").append(fault.type));
    const ProblemError error = only_error(response);
    EXPECT_EQ(error.pointer, fault.pointer);
    EXPECT_THAT(error.allowed, testing::HasSubstr(fault.allowed));
  }
}

// Two white mirrors face each other: each path has as many vertices as it may.
TEST(ExplainPath, OfTooManyIsCountedBeforeItIsMade) {
  const std::string hall = R"({"materials":{"mirror":{"reflection":1,"diffuse":0}},"objects":[
      {"type":"plane","point":[0,0,-1],"normal":[0,0,1],"material":"mirror"},
      {"type":"plane","point":[0,0,1],"normal":[0,0,-1],"material":"mirror"}]})";
  const auto asked = [&](int paths) {
    return host().post("/explain",
                       R"({"integrator":"path","samples":1024,"max_depth":64,"paths":)" +
                           std::to_string(paths) + R"(,"x":320,"y":240,"scene":)" + hall + "}");
  };
  EXPECT_EQ(asked(8).status, 200);
  const ProblemError error = only_error(asked(1024));
  EXPECT_EQ(error.pointer, "/paths");
  EXPECT_THAT(error.allowed, testing::HasSubstr("4194304 bytes"));
}

}  // namespace
}  // namespace tia::test
