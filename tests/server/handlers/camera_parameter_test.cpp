// The `camera` parameter: a merge patch of the scene's camera; and where samples and seed come
// from.
#include "tests/server/picture_support.h"
#include "tests/server/support.h"

namespace tia::test {
namespace {

// A scene with this camera and these options.
std::string scene_with(const std::string& camera, const std::string& options = "{}") {
  return R"({"camera":)" + camera + R"(,"options":)" + options + R"(,"objects":[
      {"type":"sphere","center":[0,0,-9],"radius":1.5},
      {"type":"box","min":[-3,-2,-12],"max":[3,-1.5,-6]}],
      "lights":[{"type":"point","position":[4,6,-3]}]})";
}
std::string picture(const std::string& scene, const std::string& more) {
  const std::string body =
      R"({"width":37,"height":23,"scene":)" + scene + (more.empty() ? "" : "," + more) + "}";
  const Response response = host().post("/render", body);
  EXPECT_EQ(response.status, 200) << response.body;
  const Response got = host().get("/render?" + query_of(parse_json(body)));
  EXPECT_TRUE(got.body == response.body);
  return response.body;
}

struct Patch {
  const char* law;
  const char* camera;
  const char* patch;
  const char* same_as;
};
void PrintTo(const Patch& patch, std::ostream* out) { *out << patch.patch; }
class CameraPatchOf : public testing::TestWithParam<Patch> {};

TEST_P(CameraPatchOf, DrawsWhatTheCameraWithThoseFieldsDraws) {
  const auto& [law, camera, patch, same_as] = GetParam();
  const std::string patched = picture(scene_with(camera), R"("camera":)" + std::string(patch));
  EXPECT_TRUE(patched == picture(scene_with(same_as), ""));
}

const Patch patches[] = {
    {"Nothing", R"({"fov_degrees":40})", "{}", R"({"fov_degrees":40})"},
    {"OneField", R"({"fov_degrees":40})", R"({"location":[1,2,3]})",
     R"({"fov_degrees":40,"location":[1,2,3]})"},
    {"ReplacedField", R"({"fov_degrees":40})", R"({"fov_degrees":60})", R"({"fov_degrees":60})"},
    {"RemovedField", R"({"fov_degrees":40})", R"({"fov_degrees":null})", "{}"},
    {"OtherSpelling", R"({"look_at":[0,0,-9]})", R"({"look_at":null,"direction":[0.1,0,-1]})",
     R"({"direction":[0.1,0,-1]})"},
    {"Projection", "{}", R"({"projection":"orthographic","height":8})",
     R"({"projection":"orthographic","height":8})"},
    {"InsideTheBasis",
     R"({"basis":{"u":[1,0,0],"v":[0,1,0],"w":[0,0,1]},"distance":50,"pixel_size":1})",
     R"({"basis":{"u":[0,1,0],"v":[-1,0,0]}})",
     R"({"basis":{"u":[0,1,0],"v":[-1,0,0],"w":[0,0,1]},"distance":50,"pixel_size":1})"},
};
INSTANTIATE_TEST_SUITE_P(Of, CameraPatchOf, testing::ValuesIn(patches), law_of);

TEST(CameraParameter, OfANamedSceneTurnsTheEye) {
  const std::string up = R"({"look_at":[0,1000,-1]})";  // nothing but background
  const auto image =
      decode_png(host().get("/render?width=8&height=6&camera=" + url_encode(up)).body);
  for (const unsigned char code : image.rgb) EXPECT_EQ(code, 204);  // 0.8 x 255
}

TEST(CameraParameter, FaultsOfItAndOfAllElseAreNamedAtOnce) {
  const Problem problem = problem_of(host().post(
      "/render",
      R"({"width":0,"camera":{"fov":1,"up":[0,0],"fov_degrees":0},"scene":{"title":5}})"));
  std::vector<std::string> pointers;
  for (const ProblemError& error : problem.errors) pointers.push_back(error.pointer);
  EXPECT_THAT(pointers, testing::UnorderedElementsAre("/width", "/camera/fov", "/camera/up",
                                                      "/camera/fov_degrees", "/scene/title"));
}

// ---- request, else scene, else 1 ---------------------------------------------------------------

// How many rays start at the eye; pictures of normals cast no others.
std::string rays(const std::string& scene, const std::string& more, const char* of = "normal") {
  const Response response =
      host().post("/render", R"({"width":37,"height":23,"integrator":")" + std::string(of) +
                                 R"(","scene":)" + scene + more + "}");
  EXPECT_EQ(response.status, 200) << response.body;
  const std::string text = header(response, "Tia-Rays").value_or("");
  return text.substr(0, text.find(','));
}

TEST(Samples, AreTheRequestsElseTheScenesElseOne) {  // 37 x 23 = 851 pixels
  EXPECT_EQ(rays(scene_with("{}"), ""), "primary=851");
  EXPECT_EQ(rays(scene_with("{}", R"({"samples":4})"), ""), "primary=3404");
  EXPECT_EQ(rays(scene_with("{}", R"({"samples":4})"), R"(,"samples":2)"), "primary=1702");
  EXPECT_EQ(rays(scene_with("{}", R"({"samples":4})"), R"(,"samples":1)"), "primary=851");
}

TEST(Samples, OfAPictureOfObjectNumbersAreOneAPixel) {
  const std::string many = scene_with("{}", R"({"samples":4,"threshold":0.01})");
  EXPECT_EQ(rays(many, "", "object"), "primary=851");
  EXPECT_EQ(rays(many, R"(,"samples":9,"threshold":0.1)", "object"), "primary=851");
}

TEST(Threshold, AddsRaysWhereAPixelsOwnDisagree) {
  const std::string flat = R"({"background":[0.5,0.5,0.5],"options":{"threshold":0.01}})";
  EXPECT_EQ(rays(flat, ""), "primary=3404");  // four each: all agree
  EXPECT_EQ(rays(flat, R"(,"threshold":0)"), "primary=851");
  EXPECT_NE(rays(scene_with("{}"), R"(,"threshold":0.01)"), "primary=3404");
}

TEST(Seed, IsTheRequestsElseTheScenesElseZero) {
  const std::string plain = scene_with("{}", R"({"samples":4})");
  const std::string seeded = scene_with("{}", R"({"samples":4,"seed":7})");
  EXPECT_TRUE(picture(plain, R"("seed":7)") == picture(seeded, ""));
  EXPECT_TRUE(picture(plain, "") == picture(seeded, R"("seed":0)"));
  EXPECT_FALSE(picture(plain, "") == picture(seeded, ""));
}

}  // namespace
}  // namespace tia::test
