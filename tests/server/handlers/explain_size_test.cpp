// Explanations are bounded before they are made, and name each object so that it can be told from
// others of its name.
#include <nlohmann/json.hpp>

#include "core/render/explain.h"
#include "tests/server/picture_support.h"
#include "tests/server/support.h"

namespace tia::test {
namespace {

using Json = nlohmann::json;  // trees nest deeper than requests may

Response asked(const std::string& scene, const std::string& more) {
  return host().post(
      "/explain",
      R"({"scene":)" + scene + R"(,"ray":{"origin":[0,0,0],"direction":[0,0,-1]})" + more + "}");
}
Json explanation_of_scene(const std::string& scene, const std::string& more = "") {
  const Response response = asked(scene, more);
  EXPECT_EQ(response.status, 200) << response.body.substr(0, 1000);
  EXPECT_LE(response.body.size(), longest_explanation);
  return Json::parse(response.body);
}
// The fault of what is refused, which the answer to "why" tells what to lower.
void expect_too_long(const Response& response, const char* pointer) {
  EXPECT_EQ(response.status, 422) << response.body.substr(0, 1000);
  EXPECT_EQ(problem_of(response).type, "/problems/limit");
  const ProblemError error = only_error(response);
  EXPECT_EQ(error.pointer, pointer);
  EXPECT_THAT(error.allowed, testing::HasSubstr("4194304 bytes"));
}

// ---- names ----------------------------------------------------------------------------------

TEST(ExplainNames, ObjectsOfOneNameAreToldApartByTheirIds) {
  const Json answer = explanation_of_scene(R"({"objects":[
    {"type":"sphere","name":"twin","center":[0,0,-5],"radius":1,"material":{"reflection":0.5}},
    {"type":"plane","point":[0,-9,0],"normal":[0,1,0]},
    {"type":"group","children":[{"type":"disc","name":"twin","center":[0,0,-9],"normal":[0,0,1],
      "radius":2}]},
    {"type":"box","min":[-1,-1,3],"max":[1,1,4]}],
    "lights":[{"type":"point","position":[0,0,-6]}]})");
  ASSERT_EQ(answer.at("hits").size(), 3U);
  EXPECT_EQ(answer["hits"][0].at("object"), "twin");
  EXPECT_EQ(answer["hits"][2].at("object"), "twin");
  EXPECT_EQ(answer["hits"][0].at("id"), 1);
  EXPECT_EQ(answer["hits"][2].at("id"), 3);
  const Json& tree = answer.at("tree");
  EXPECT_EQ(tree.at("winner_id"), 1);
  EXPECT_EQ(tree.at("terms").back().at("node").at("winner"), "/objects/3");
  EXPECT_EQ(tree.at("terms").back().at("node").at("winner_id"), 4);
  const Json expected = Json::parse(R"([
    {"id":1,"name":"twin","pointer":"/objects/0","type":"sphere"},
    {"id":3,"name":"twin","pointer":"/objects/2/children/0","type":"disc"},
    {"id":4,"name":"/objects/3","pointer":"/objects/3","type":"box"}])");
  EXPECT_EQ(answer.at("objects"), expected);
}

// The ids are those of the image `object`.
TEST(ExplainNames, IdsAreTheNumbersOfTheObjectImage) {
  const std::string view = "scene=shapes&width=16&height=12";
  const auto image = decode_pfm(host().get("/render?format=pfm&integrator=object&" + view).body);
  for (int y = 0; y < 12; y += 2)
    for (int x = 0; x < 16; x += 2) {
      const Json tree = Json::parse(host()
                                        .get("/explain?" + view + "&samples=1&threshold=0&x=" +
                                             std::to_string(x) + "&y=" + std::to_string(y))
                                        .body)
                            .at("tree");
      EXPECT_EQ(tree.value("winner_id", 0), image.at(x, y, 0)) << x << " " << y;
    }
}

// ---- how long -------------------------------------------------------------------------------

// So many lamps over a wall, all hidden from it by a shade.
std::string lamps(int count, const std::string& name) {
  std::string list;
  for (int i = 0; i < count; ++i)
    list += std::string(i > 0 ? "," : "") + R"({"type":"point","position":[)" +
            std::to_string(0.0001 * i) + ",20,0]}";
  return R"({"objects":[{"type":"plane","name":")" + name +
         R"(","point":[0,0,-5],"normal":[0,0,1]},{"type":"disc","name":")" + name +
         R"(","center":[0,10,-2.5],"normal":[0,1,0],"radius":3}],"lights":[)" + list + "]}";
}

TEST(ExplainSize, OfManyLampsIsCountedBeforeItIsMade) {
  const std::string long_name(256, 'n');
  int longest = 0;
  for (const int count : {2000, 5000, 8000}) {
    const Response response = asked(lamps(count, long_name), "");
    if (response.status == 200) longest = count;
    else expect_too_long(response, "/max_depth");
    EXPECT_LE(response.body.size(), longest_explanation);
  }
  EXPECT_EQ(longest, 5000);
}

// Two mirrors face each other: one ray after the other, each lit by lamps.
TEST(ExplainSize, OfAHallOfMirrorsIsItsRays) {
  const std::string mirror = R"("material":{"reflection":0.9}})";
  const std::string hall = R"({"objects":[{"type":"plane","name":")" + std::string(256, 'a') +
                           R"(","point":[0,0,-1],"normal":[0,0,1],)" + mirror +
                           R"(,{"type":"plane","name":")" + std::string(256, 'b') +
                           R"(","point":[0,0,1],"normal":[0,0,-1],)" + mirror + "]}";
  const Json answer = explanation_of_scene(hall, R"(,"max_depth":64)");
  int depth = 0;
  for (const Json* node = &answer.at("tree");; ++depth) {
    const Json& last = node->at("terms").back();
    if (!last.contains("node")) break;
    node = &last["node"];
  }
  EXPECT_EQ(depth, 64);
}

// Panes that mirror and let through: each ray makes two, 2^64 in all.
TEST(ExplainSize, OfATreeOfRaysIsCountedAsItGrows) {
  std::string panes;
  for (int i = 0; i < 40; ++i)
    panes += std::string(i > 0 ? "," : "") + R"({"type":"box","name":")" + std::string(250, 'p') +
             R"(","min":[-9,-9,)" + std::to_string(-3 - i) + R"(],"max":[9,9,)" +
             std::to_string(-2.5 - i) +
             R"(],"material":{"reflection":0.5,"transmission":0.5,"fresnel":true,"ior":1.5}})";
  const std::string scene = R"({"objects":[)" + panes + "]}";
  expect_too_long(asked(scene, R"(,"max_depth":64)"), "/max_depth");
  EXPECT_GT(explanation_of_scene(scene, R"(,"max_depth":6)").dump().size(), 10'000U);
}

TEST(ExplainSize, OfManySurfacesIsCountedBeforeItIsMade) {
  const auto row = [](int count) {
    return R"({"objects":[{"type":"group","repeat":{"count":[1,1,)" + std::to_string(count) +
           R"(],"step":[0,0,-3]},"children":[{"type":"sphere","name":")" + std::string(256, 's') +
           R"(","center":[0,0,-3],"radius":1}]}]})";
  };
  explanation_of_scene(row(2000));
  expect_too_long(asked(row(4900), ""), "");
}

// What is counted is what may come, and not much more.
TEST(ExplainSize, IsNoLessThanTheJsonAndNotThreeTimesIt) {
  Pool pool(2);
  for (const auto& [name, scene] : host().gallery().scenes()) {
    SCOPED_TRACE(name);
    RenderOptions options;
    options.max_depth = 5;
    const World world = host().geometries().compile(scene, pool.workers(2));
    for (int i = 0; i < rounds(5); ++i) {
      const Explanation all =
          explain(*scene, world, view_of(scene->camera, 50, 40), 7 + 8 * i, 20 + i, 0, options);
      const std::size_t bytes = to_json(value_of(all)).size();
      EXPECT_LE(bytes, all.most_bytes);
      EXPECT_LE(all.most_bytes, 3 * bytes + 4096);
    }
  }
}

}  // namespace
}  // namespace tia::test
