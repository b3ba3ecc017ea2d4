// Scenes that show models, over HTTP.
#include "server/stores/digest.h"
#include "tests/core/png/png_reader.h"
#include "tests/server/model_support.h"
#include "tests/server/process_support.h"
#include "tests/server/support.h"

namespace tia::test {
namespace {

using testing::HasSubstr;

// What stl_text() holds, upright as it is there, in the material of files that have none.
constexpr const char* same_mesh =
    R"({"type":"mesh","positions":[0,0,0,1,0,0,0,1,0],"indices":[0,1,2],
        "material":{"type":"principled","base_color":[0.8,0.8,0.8]}})";

std::string placed(const std::string& id, const std::string& members = R"(,"up":"y")") {
  return R"({"type":"model","id":")" + id + '"' + members + "}";
}
// The body of a request for its picture, lit from the front.
std::string picture_of_object(const std::string& object, const std::string& members = "") {
  return R"({"width":40,"height":30,"format":"pfm","scene":{"camera":{"location":[0,0,3]},
    "lights":[{"type":"point","position":[1,2,4]}],"keys":{"k":{"background":[0,0,1]}},
    "objects":[)" +
         object + "]}" + members + "}";
}
Response drawn(Host& at_host, const std::string& body) { return at_host.post("/render", body); }
std::string kept_id(Host& at_host) {
  return text_at(parse_json(at_host.post("/models", stl_text(), "model/stl").body), "id");
}

TEST(ModelScenes, ShowWhatTheSameMeshShows) {
  Host own;
  const std::string id = kept_id(own);
  const Response model = drawn(own, picture_of_object(placed(id)));
  ASSERT_EQ(model.status, 200) << model.body;
  EXPECT_EQ(model.body, drawn(own, picture_of_object(same_mesh)).body);
  const std::string group = R"({"type":"group","children":[)" + placed(id) + "]}";
  EXPECT_EQ(drawn(own, picture_of_object(group)).body, model.body);
  EXPECT_NE(drawn(own, picture_of_object(placed(id, R"(,"up":"z")"))).body, model.body);
}

TEST(ModelScenes, KeepTheirModelsWhenAKeyIsPressedOrTheLightMoved) {
  Host own;
  const std::string id = kept_id(own);
  for (const char* members : {R"(,"key":"k")", R"(,"light":[0,1,2])"}) {
    const Response model = drawn(own, picture_of_object(placed(id), members));
    ASSERT_EQ(model.status, 200) << model.body;
    EXPECT_EQ(model.body, drawn(own, picture_of_object(same_mesh, members)).body);
  }
}

TEST(ModelScenes, AreKeptByTheirIdsAndSayWhichModelIsMissing) {
  Host own;
  const std::string unknown = sha256_hex("no model");
  for (const std::string& id : {unknown, std::string("../../etc/passwd")}) {
    const Response refused = drawn(own, picture_of_object(placed(id)));
    EXPECT_EQ(refused.status, 422);
    EXPECT_THAT(refused.body, HasSubstr("/scene/objects/0/id"));
    EXPECT_THAT(refused.body, HasSubstr(id));
  }
  const std::string id = kept_id(own);
  const Response variant = drawn(own, picture_of_object(placed(id, R"(,"variant":"red")")));
  EXPECT_EQ(variant.status, 422);
  EXPECT_THAT(variant.body, HasSubstr("/scene/objects/0/variant"));
}

TEST(ModelScenes, TellTheModelsIdInTheirRecipeAndDrawAgainFromIt) {
  Host own;
  const std::string id = kept_id(own);
  std::string asked = picture_of_object(placed(id));
  asked.replace(asked.find("pfm"), 3, "png");
  const Response picture = drawn(own, asked);
  ASSERT_EQ(picture.status, 200) << picture.body;
  const Response again = own.post("/render", picture.body, "image/png");
  EXPECT_EQ(again.status, 200) << again.body;
  EXPECT_EQ(again.body, picture.body);
  Host other;  // which has never seen the model
  EXPECT_EQ(other.post("/render", picture.body, "image/png").status, 422);
}

TEST(ModelScenes, ArePicturesBeforeATransparentBackdrop) {
  Host own;
  std::string asked = picture_of_object(placed(kept_id(own)));
  asked.replace(asked.find(R"("camera")"), 8, R"("backdrop":"transparent","camera")");
  const Response linear = drawn(own, asked);
  EXPECT_EQ(linear.status, 422);
  EXPECT_THAT(linear.body, HasSubstr("/format"));
  asked.replace(asked.find("pfm"), 3, "png");
  const Response picture = drawn(own, asked);
  ASSERT_EQ(picture.status, 200) << picture.body;
  const Png png = read_png(picture.body);
  ASSERT_EQ(png.rgba.size(), 4U * 40 * 30);
  // From 3 before the triangle 15 pixels are 3 tan(12.5 degrees): pixel (22, 12) sees (0.11, 0.11)
  // with all of its rays, pixel (5, 5) something far to the left with all of them.
  const auto alpha_at = [&](std::size_t x, std::size_t y) {
    return static_cast<unsigned char>(png.rgba[4 * (40 * y + x) + 3]);
  };
  EXPECT_EQ(alpha_at(22, 12), 255);
  EXPECT_EQ(alpha_at(5, 5), 0);
}

}  // namespace
}  // namespace tia::test
