// The gallery's models: the list, their names as ids, and a model's file as a scene.
#include <filesystem>
#include <set>

#include "server/stores/digest.h"
#include "server/stores/gallery_models.h"
#include "tests/server/model_support.h"
#include "tests/server/support.h"

namespace tia::test {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

fs::path models_folder() { return std::string(TIA_SOURCE_DIR) + "/web/models"; }

Response picture_of_model(const std::string& name) {
  return host().post("/render", R"({"width":24,"height":18,"format":"pfm","scene":{"camera":
    {"location":[0,0.3,0.6],"look_at":[0,0,0]},"lights":[{"type":"point","position":[1,2,4]}],
    "objects":[{"type":"model","id":")" +
                                    name + R"("}]}})");
}

TEST(GalleryModels, AreTheFilesOfWebModels) {
  const Value told = parse_json(host().get("/models").body);
  const auto& list = *at(told, "models").as<Value::Array>();
  std::map<std::string, fs::path> files;
  for (const auto& each : fs::directory_iterator(models_folder()))
    if (each.path().extension() != ".md") files[each.path().stem().string()] = each.path();
  ASSERT_EQ(list.size(), files.size());
  auto file = files.begin();
  for (std::size_t i = 0; i < list.size(); ++i, ++file) {
    const std::string bytes = file_bytes(file->second.string());
    EXPECT_EQ(text_at(list[i], "name"), file->first);
    EXPECT_EQ(text_at(list[i], "id"), sha256_hex(bytes));
    EXPECT_EQ("." + text_at(list[i], "format"), file->second.extension());
    EXPECT_EQ(number_at(list[i], "bytes"), static_cast<double>(bytes.size()));
    EXPECT_EQ(text_at(list[i], "location"), "/models/" + file->first);
  }
}

TEST(GalleryModels, AllAreReadWithoutAWarningUnderNameAndId) {
  for (const GalleryModel& model : gallery_models()) {
    const Response by_name = host().get("/models/" + std::string(model.name));
    ASSERT_EQ(by_name.status, 200) << by_name.body;
    const Value told = parse_json(by_name.body);
    EXPECT_EQ(text_at(told, "id"), model.id);
    EXPECT_EQ(text_at(told, "format"), model.format);
    EXPECT_TRUE(at(told, "warnings").as<Value::Array>()->empty()) << by_name.body;
    EXPECT_EQ(host().get("/models/" + model.id).body, by_name.body);
    EXPECT_EQ(host().head("/models/" + model.id).status, 200);
    EXPECT_EQ(host().head("/models/" + std::string(model.name)).status, 200);
  }
}

TEST(GalleryModels, AreReadOnceWhenTheyAreAskedForAndThenStay) {
  Host own;
  const auto reads = [&] {
    return series_of(own.get("/metrics").body)["tia_model_read_seconds_count"];
  };
  EXPECT_EQ(own.head("/models/part").status, 200);
  EXPECT_EQ(reads(), 0);
  EXPECT_EQ(own.get("/models/part").status, 200);
  EXPECT_EQ(own.get("/models/part/scene").status, 200);
  EXPECT_EQ(own.get("/models/part").status, 200);
  EXPECT_EQ(reads(), 1);
}

TEST(GalleryModels, AreKeptAlreadyForWhoSendsOne) {
  Host own;
  const GalleryModel& part = *gallery_model("part");
  const Response sent = own.post("/models", std::string(part.bytes), "model/stl");
  EXPECT_EQ(sent.status, 200);
  EXPECT_EQ(header(sent, "Location"), "/models/" + part.id);
  EXPECT_EQ(series_of(own.get("/metrics").body)["tia_models{state=\"kept\"}"], 0);
}

TEST(GalleryModels, AreShownInScenesByNameAsById) {
  const Response by_name = picture_of_model("chess");
  ASSERT_EQ(by_name.status, 200) << by_name.body;
  EXPECT_EQ(picture_of_model(gallery_model("chess")->id).body, by_name.body);
  const Response none = picture_of_model("ches");
  EXPECT_EQ(none.status, 422);
  EXPECT_THAT(none.body, HasSubstr("/scene/objects/0/id"));
  EXPECT_THAT(none.body, HasSubstr("gallery"));
}

TEST(GalleryModels, ANameOfNoneIs404WithThoseThatThereAre) {
  for (const char* path : {"/models/ches", "/models/ches/scene", "/models/chess.glb",
                           "/models/..%2fscenes.sqlite/scene"}) {
    const Response none = host().get(path);
    EXPECT_EQ(none.status, 404) << path;
    for (const GalleryModel& model : gallery_models())
      EXPECT_THAT(problem_of(none).detail, HasSubstr(std::string(model.name)));
    EXPECT_EQ(host().head(path).status, 404) << path;
  }
  EXPECT_EQ(host().get("/models//scene").status, 404);
  EXPECT_EQ(host().get("/models/chess/a/scene").status, 404);
}

// ---- tags ---------------------------------------------------------------------------------------

TEST(TagsOfModels, TellThatTheClientHasThemAndDifferFromEachOther) {
  std::set<std::string> tags;
  const std::vector<std::string> paths{"/models", "/models/part", "/models/part/scene",
                                       "/models/" + gallery_model("part")->id, "/models/chess"};
  for (const std::string& path : paths) {
    SCOPED_TRACE(path);
    const Response whole = host().get(path);
    const std::string tag = header(whole, "ETag").value_or("none");
    tags.insert(tag);
    EXPECT_EQ(header(whole, "Cache-Control"), "no-cache");
    EXPECT_EQ(header(host().head(path), "ETag"), tag);
    const Response known = host().get(path, {{"If-None-Match", "\"a\", " + tag}});
    EXPECT_EQ(known.status, 304);
    EXPECT_EQ(known.body, "");
    EXPECT_EQ(header(known, "ETag"), tag);
    EXPECT_EQ(header(known, "Cache-Control"), "no-cache");
    const Response changed = host().get(path, {{"If-None-Match", "\"a\""}});
    EXPECT_EQ(changed.status, 200);
    EXPECT_EQ(changed.body, whole.body);
  }
  EXPECT_EQ(tags.size(), paths.size());
}

TEST(TagsOfModels, AreKnownBeforeAnythingIsRead) {
  Host own;
  for (const char* path : {"/models/part", "/models/part/scene"}) {
    const std::string tag = header(own.head(path), "ETag").value();
    EXPECT_EQ(own.get(path, {{"If-None-Match", tag}}).status, 304);
  }
  EXPECT_EQ(series_of(own.get("/metrics").body)["tia_model_read_seconds_count"], 0);
}

TEST(TagsOfModels, AreOfModelsThatAreThere) {
  for (const char* path : {"/models/parts", "/models/parts/scene"})
    EXPECT_EQ(host().get(path, {{"If-None-Match", "*"}}).status, 404);
}

// ---- as scenes ----------------------------------------------------------------------------------

TEST(ModelSceneOverHttp, IsDrawnByRender) {
  for (const GalleryModel& model : gallery_models()) {
    const Response scene = host().get("/models/" + std::string(model.name) + "/scene");
    ASSERT_EQ(scene.status, 200) << scene.body;
    const Response picture = host().post(
        "/render", R"({"width":16,"height":12,"samples":1,"scene":)" + scene.body + "}");
    EXPECT_EQ(picture.status, 200) << model.name << picture.body;
    EXPECT_EQ(picture.content_type, "image/png");
  }
}

TEST(ModelSceneOverHttp, HasTheFilesOwnCameraAndLights) {
  const Value scene = parse_json(host().get("/models/lantern/scene").body);
  EXPECT_EQ(to_json(at(at(scene, "camera"), "location")), "[0.22,0.21,0.56]");
  const auto& lights = *at(scene, "lights").as<Value::Array>();
  ASSERT_EQ(lights.size(), 2U);
  EXPECT_EQ(text_at(lights[0], "type"), "directional");
  EXPECT_EQ(number_at(lights[0], "intensity"), 0.9);
  EXPECT_EQ(text_at(lights[1], "type"), "spot");
  EXPECT_EQ(number_at(lights[1], "intensity"), 0.55);
}

TEST(ModelSceneOverHttp, IsOfModelsThatClientsHaveSentToo) {
  Host own;
  const std::string id = sha256_hex(stl_text());
  EXPECT_EQ(own.get("/models/" + id + "/scene").status, 404);
  own.post("/models", stl_text(), "model/stl");
  const Response scene = own.get("/models/" + id + "/scene");
  ASSERT_EQ(scene.status, 200) << scene.body;
  EXPECT_EQ(to_json(at(parse_json(scene.body), "objects")),
            R"([{"id":")" + id + R"(","type":"model"}])");
  EXPECT_EQ(own.head("/models/" + id + "/scene").status, 200);
}

}  // namespace
}  // namespace tia::test
