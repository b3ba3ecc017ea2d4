// POST /scenes: an id that works wherever a name does, and what is said of a scene that is wrong.
#include <httplib.h>

#include <algorithm>
#include <thread>

#include "core/scene/read_scene.h"
#include "server/stores/digest.h"
#include "server/stores/scene_bytes.h"
#include "tests/server/socket_support.h"

namespace tia::test {
namespace {

using testing::HasSubstr;

const std::string lit_ball = R"({"title":"A ball","objects":[
    {"type":"sphere","name":"ball","center":[0,0,-9],"radius":1.5,
     "material":{"color":[1,0.4,0.1]}}],
    "lights":[{"type":"point","position":[4,6,-3]}]})";

std::string kept(Host& at_host, const std::string& scene) {
  const Response response = at_host.post("/scenes", scene);
  EXPECT_EQ(response.status, 201) << response.body;
  return text_at(parse_json(response.body), "id");
}

TEST(PostScenes, Answers201WithTheScenesPlaceAndId) {
  const Response response = host().post("/scenes", lit_ball);
  EXPECT_EQ(response.status, 201);
  EXPECT_EQ(response.content_type, "application/json");
  const std::string text = canonical_text(read_scene(lit_ball));
  const Value body = parse_json(response.body);
  EXPECT_EQ(text_at(body, "id"), sha256_hex(text));
  EXPECT_EQ(text_at(body, "location"), "/scenes/" + sha256_hex(text));
  EXPECT_EQ(header(response, "Location"), text_at(body, "location"));
  const Response scene = host().get(text_at(body, "location"));
  EXPECT_EQ(scene.status, 200);
  EXPECT_EQ(scene.content_type, "application/json");
  EXPECT_EQ(scene.body, text);
}

TEST(PostScenes, TheSameSceneHasTheSameIdHoweverItIsSpelled) {
  const std::string id = kept(host(), lit_ball);
  EXPECT_EQ(kept(host(), lit_ball), id);
  EXPECT_EQ(kept(host(), canonical_text(read_scene(lit_ball))), id);
  EXPECT_EQ(kept(host(), to_json(parse_json(lit_ball))), id);
  EXPECT_NE(kept(host(), R"({"title":"Another"})"), id);
}

TEST(PostScenes, AGallerysSceneMayBeKeptToo) {
  const std::string id = kept(host(), host().get("/scenes/thesis").body);
  EXPECT_TRUE(host().get("/render?key=a&width=37&height=23&scene=" + id).body ==
              host().get("/render?key=a&width=37&height=23").body);
}

TEST(PostScenes, TheIdDrawsWhatTheSceneDraws) {
  const std::string id = kept(host(), lit_ball);
  for (const char* format : {"png", "pfm", "hdr", "exr"}) {
    Value::Object asked{{"width", 37}, {"height", 23}, {"format", format}, {"key", "d"}};
    Value::Object whole = asked;
    asked.emplace_back("scene", id);
    whole.emplace_back("scene", parse_json(lit_ball));
    const Response by_id = host().post("/render", to_json(asked));
    EXPECT_EQ(by_id.status, 200);
    EXPECT_TRUE(host().get("/render?" + query_of(asked)).body == by_id.body);
    EXPECT_TRUE(host().post("/render", to_json(whole)).body == by_id.body);
    EXPECT_TRUE(host().get("/render?" + query_of(whole)).body == by_id.body);
    EXPECT_EQ(host().head("/render?" + query_of(asked)).status, 200);
  }
}

TEST(PostScenes, TheIdIsExplainedAsTheScene) {
  const std::string id = kept(host(), lit_ball);
  const Response response = host().get("/explain?x=320&y=240&scene=" + id);
  EXPECT_EQ(response.status, 200);
  EXPECT_EQ(response.body, host().get("/explain?x=320&y=240&scene=" + url_encode(lit_ball)).body);
  EXPECT_THAT(response.body, HasSubstr(R"("object":"ball")"));
}

TEST(PostScenes, KeptScenesAreNotListed) {
  const std::string before = host().get("/scenes").body;
  kept(host(), R"({"title":"Private"})");
  EXPECT_EQ(host().get("/scenes").body, before);
}

TEST(PostScenes, ASceneThatFellOutIsUnknownAgain) {
  Config config;
  config.max_scenes_bytes = static_cast<std::int64_t>(2 * bytes_of(read_scene(lit_ball)));
  Host small(config);
  const std::string id = kept(small, lit_ball);
  EXPECT_EQ(small.head("/render?scene=" + id).status, 200);
  for (int i = 0; i < 9; ++i) kept(small, R"({"title":")" + std::to_string(i) + "\"}");
  EXPECT_EQ(small.get("/scenes/" + id).status, 404);
  EXPECT_THAT(problem_of(small.get("/scenes/" + id)).detail, HasSubstr("POST /scenes"));
  const Response render = small.get("/render?scene=" + id);
  EXPECT_EQ(render.status, 422);
  EXPECT_EQ(problem_of(render).type, "/problems/unknown-name");
  EXPECT_EQ(only_error(render).pointer, "/scene");
  EXPECT_THAT(only_error(render).allowed, HasSubstr("still kept"));
  EXPECT_EQ(kept(small, lit_ball), id);
  EXPECT_EQ(small.get("/scenes/" + id).status, 200);
}

TEST(PostScenes, ASceneBeyondTheStoreNamesTheLimitAndItsOption) {
  Config config;
  config.max_scenes_bytes = 100;
  Host small(config);
  const Response response = small.post("/scenes", lit_ball);
  EXPECT_EQ(response.status, 422);
  EXPECT_EQ(problem_of(response).type, "/problems/limit");
  EXPECT_EQ(only_error(response).pointer, "");
  EXPECT_THAT(only_error(response).allowed, HasSubstr("100 bytes"));
  EXPECT_THAT(only_error(response).allowed, HasSubstr("TIA_MAX_SCENES_BYTES"));
}

// ---- faults ------------------------------------------------------------------------------------

TEST(PostScenes, PointersAreIntoTheScene) {
  const std::string ball = R"({"type":"sphere","center":[0,0,-5],"radius":1})";
  const std::string flat = R"({"type":"sphere","center":[0,0,-5],"radius":0})";
  const std::string text = R"({"objects":[)" + ball + "," + ball + "," + ball + "," + flat + "]}";
  const Response response = host().post("/scenes", text);
  EXPECT_EQ(response.status, 422);
  EXPECT_EQ(only_error(response).pointer, "/objects/3/radius");
  EXPECT_EQ(only_error(host().post("/render", R"({"scene":)" + text + "}")).pointer,
            "/scene/objects/3/radius");
}

TEST(PostScenes, AllFaultsAreNamedAtOnceUpTo20) {
  std::string objects;
  for (int i = 1; i <= 30; ++i) {
    if (i > 1) objects += ',';
    objects += R"({"type":"sphere","center":[0,0,0],"radius":-)";
    objects += std::to_string(i) + '}';
    const Response response = host().post("/scenes", R"({"objects":[)" + objects + "]}");
    EXPECT_EQ(response.status, 422);
    const Problem problem = problem_of(response);
    ASSERT_EQ(problem.errors.size(), static_cast<std::size_t>(std::min(i, 20)));
    for (std::size_t k = 0; k < problem.errors.size(); ++k)
      EXPECT_EQ(problem.errors[k].pointer, "/objects/" + std::to_string(k) + "/radius");
  }
}

TEST(PostScenes, DifferentFaultsAreNamedTogether) {
  const Problem problem = problem_of(host().post("/scenes", R"({
      "camera": {"fov": 30, "location": [0,0,1e10]},
      "backgruond": [0,0,0],
      "objects": [{"type":"spere"}, {"type":"sphere","center":[0,0]},
                  {"type":"csg","operation":"union","children":[
                    {"type":"disc","center":[0,0,0],"normal":[0,0,1],"radius":1}]},
                  {"type":"sphere","center":[0,0,0],"radius":1,"transform":[{"scale":0}]}],
      "lights": [{"type":"point"}]})"));
  std::vector<std::string> pointers;
  for (const ProblemError& error : problem.errors) pointers.push_back(error.pointer);
  EXPECT_THAT(pointers, testing::UnorderedElementsAre(
                            "/camera/fov", "/camera/location/2", "/backgruond", "/objects/0/type",
                            "/objects/1/center", "/objects/1/radius", "/objects/2/children/0/type",
                            "/objects/3/transform/0/scale", "/lights/0/position"));
}

TEST(PostScenes, WhatIsNoSceneIsRefused) {
  EXPECT_EQ(host().post("/scenes", "{").status, 400);
  EXPECT_EQ(host().post("/scenes", R"({"title":"a","title":"b"})").status, 400);
  EXPECT_EQ(host().post("/scenes", "title=a", "text/plain").status, 415);
  EXPECT_EQ(host().post("/scenes", "[]").status, 422);
  EXPECT_EQ(problem_of(host().post("/scenes?keep=1", lit_ball)).type, "/problems/conflict");
  EXPECT_EQ(host().post("/scenes", R"({"scene":"thesis"})").status, 422);
  const Response put = host().ask("PUT", "/scenes", lit_ball);
  EXPECT_EQ(put.status, 405);
  EXPECT_EQ(header(put, "Allow"), "GET, HEAD, POST, OPTIONS");
}

// ---- sockets and threads -------------------------------------------------------------------

TEST(PostScenes, WorksOverASocket) {
  Server server;
  auto client = server.client();
  const Response response = plain(
      "POST", "/scenes", client.Post("/scenes", lit_ball, "application/x-www-form-urlencoded"));
  EXPECT_EQ(response.status, 201);
  const std::string location = header(response, "Location").value_or("");
  EXPECT_EQ(location, "/scenes/" + text_at(parse_json(response.body), "id"));
  EXPECT_EQ(plain("GET", location, client.Get(location)).body,
            canonical_text(read_scene(lit_ball)));
  const std::string picture =
      "/render?width=37&height=23&scene=" + text_at(parse_json(response.body), "id");
  EXPECT_TRUE(plain("GET", picture, client.Get(picture)).body == server.host().get(picture).body);
}

TEST(PostScenes, ClientsThatKeepAndDrawAtOnceGetTheirOwnPictures) {
  constexpr int clients = 6, each = 8;
  const auto scene_of = [](int number) {
    return R"({"background":[0,0,)" + std::to_string(number % 5 * 0.25) + "]}";
  };
  const auto picture = [](Host& at_host, const std::string& id) {
    return at_host.get("/render?width=9&height=7&scene=" + id);
  };
  std::vector<std::string> expected;
  for (int i = 0; i < 5; ++i) expected.push_back(picture(host(), kept(host(), scene_of(i))).body);
  Config config;  // room for about two: they push each other out
  config.max_scenes_bytes = static_cast<std::int64_t>(3 * bytes_of(Scene{}));
  Host small(config);
  std::vector<std::thread> running;
  for (int c = 0; c < clients; ++c)
    running.emplace_back([&, c] {
      for (int i = 0; i < each; ++i) {
        const Response drawn = picture(small, kept(small, scene_of(c + i)));
        const auto number = static_cast<std::size_t>((c + i) % 5);
        if (drawn.status == 200) EXPECT_TRUE(drawn.body == expected[number]);
        else EXPECT_EQ(problem_of(drawn).type, "/problems/unknown-name");
      }
    });
  for (std::thread& thread : running) thread.join();
  EXPECT_LE(small.kept().bytes(), 3 * bytes_of(Scene{}));
}

}  // namespace
}  // namespace tia::test
