// /scenes, /schema/scene.json, /version, /healthz.
#include "core/scene/read_scene.h"
#include "tests/server/support.h"

namespace tia::test {
namespace {

Value json_of(const Response& response) {
  EXPECT_EQ(response.status, 200);
  return parse_json(response.body);
}

TEST(Scenes, TheListNamesEverySceneOfTheGallery) {
  const Response response = host().get("/scenes");
  EXPECT_EQ(response.content_type, "application/json");
  const Value list = at(json_of(response), "scenes");
  ASSERT_EQ(list.as<Value::Array>()->size(), host().gallery().names().size());
  for (const Value& entry : *list.as<Value::Array>()) {
    const KnownScene scene = host().gallery().find(text_at(entry, "name"));
    ASSERT_TRUE(scene);
    EXPECT_EQ(text_at(entry, "title"), scene->title);
    EXPECT_EQ(host().get("/scenes/" + url_encode(text_at(entry, "name"))).status, 200);
  }
}

TEST(Scenes, TheThesisIsAmongThem) {
  EXPECT_EQ(text_at(json_of(host().get("/scenes/thesis")), "title"), "Two balls");
}

TEST(Scenes, ASceneIsItsCanonicalTextWhichIsAFixedPoint) {
  for (const auto& [name, scene] : host().gallery().scenes()) {
    SCOPED_TRACE(name);
    const Response response = host().get("/scenes/" + name);
    EXPECT_EQ(response.content_type, "application/json");
    EXPECT_EQ(response.body, to_json(parse_json(response.body)));  // RFC 8785
    const Scene again = read_scene(response.body);
    EXPECT_EQ(again, *scene);
    EXPECT_EQ(canonical_text(again), response.body);
  }
}

TEST(Scenes, CanonicalTextDoesNotDependOnOrderSpaceOrDefaults) {
  const Scene terse = read_scene(R"({"title":"x","background":[0.5,0.5,0.5]})");
  const Scene wordy = read_scene(
      " { \"background\" : 5e-1 , \"lights\":[], \"objects\": [ ],\n\t\"title\":\"\\u0078\" } ");
  EXPECT_EQ(canonical_text(terse), canonical_text(wordy));
}

TEST(Schema, IsJsonSchemaOfTheScenesOwnFields) {
  const Response response = host().get("/schema/scene.json");
  EXPECT_EQ(response.content_type, "application/schema+json");
  const Value schema = json_of(response);
  EXPECT_EQ(text_at(schema, "$schema"), "https://json-schema.org/draft/2020-12/schema");
  EXPECT_EQ(text_at(schema, "type"), "object");
  EXPECT_EQ(at(schema, "additionalProperties"), Value(false));
  const Value scene = parse_json(host().get("/scenes/thesis").body);
  for (const auto& [name, value] : *scene.as<Value::Object>())
    EXPECT_FALSE(text_at(at(at(schema, "properties"), name), "description").empty()) << name;
}

TEST(Version, NamesTheVersionAndAllThatTheBytesDependOn) {
  const Response response = host().get("/version");
  EXPECT_EQ(response.content_type, "application/json");
  const Value build = json_of(response);
  EXPECT_EQ(text_at(build, "version"), version());
  EXPECT_EQ(text_at(build, "bytes"), full_version());
  EXPECT_NE(full_version().find("libdeflate"), std::string::npos);
}

TEST(Version, NamesTheFormatsOfFilmsThatThisServerGives) {
  const auto films = [](const std::string& ffmpeg) {
    Config config;
    config.ffmpeg = ffmpeg;
    Host own(config);
    return to_json(at(json_of(own.get("/version")), "films"));
  };
  EXPECT_EQ(films(""), R"(["apng","webp","webm","zip","mjpeg"])");
  EXPECT_EQ(films("/usr/bin/ffmpeg"), R"(["apng","webp","webm","zip","mjpeg","mp4"])");
}

TEST(Health, IsOkAndNeverStored) {
  const Response response = host().get("/healthz");
  EXPECT_EQ(text_at(json_of(response), "status"), "ok");
  EXPECT_EQ(header(response, "Cache-Control"), "no-store");
}

// An object, the array in it and the rest empty strings: that many JSON values.
std::string text_of_nodes(int count) {
  std::string text = R"({"objects":[)";
  for (int i = 2; i < count; ++i) text += i > 2 ? R"(,"")" : R"("")";
  return text + "]}";
}

TEST(Nodes, ATextMayHoldAsManyValuesAsTheOptionSays) {
  Config config;
  config.max_nodes = 4096;
  Host small(config);
  for (const char* path : {"/scenes", "/explain", "/render"}) {
    EXPECT_NE(problem_of(small.post(path, text_of_nodes(4096))).type, "/problems/limit");
    const Response response = small.post(path, text_of_nodes(4097));
    EXPECT_EQ(response.status, 422);
    EXPECT_EQ(problem_of(response).type, "/problems/limit");
    const ProblemError error = only_error(response);
    EXPECT_EQ(error.pointer, "/objects/4094");
    EXPECT_THAT(error.allowed, testing::AllOf(testing::HasSubstr("at most 4096 JSON values"),
                                              testing::HasSubstr("TIA_MAX_NODES")));
  }
}

}  // namespace
}  // namespace tia::test
