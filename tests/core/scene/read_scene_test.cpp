// Scenes in: what is read, and every kind of fault at its place.
#include "core/scene/read_scene.h"

#include <gtest/gtest.h>

#include "tests/core/faults.h"
#include "tests/core/support.h"

namespace tia {
namespace {

using enum FaultKind;
using test::expect_scene_refused;

std::string with_object(const std::string& members) {
  return std::string(R"({"objects":[{)").append(members).append("}]}");
}
// A whole sphere and more members.
std::string with_sphere(const std::string& members) {
  return with_object(R"("type":"sphere","center":[0,0,0],"radius":1,)" + members);
}

// ---- what is read -----------------------------------------------------------------------------

TEST(ReadScene, ThesisSceneReadsAsItIsWritten) {
  const Scene scene = test::thesis_scene();
  EXPECT_EQ(scene.title, "Two balls");
  EXPECT_EQ(scene.camera.look_at, (Vec3d{0, 0, -1}));
  EXPECT_EQ(scene.camera.fov_degrees, 25);
  EXPECT_EQ(scene.background, (Color{0.8, 0.8, 0.8}));
  ASSERT_EQ(scene.objects.size(), 2U);
  EXPECT_EQ(scene.objects[0].name, "ball");
  EXPECT_EQ(std::get<Sphere>(scene.objects[0].shape), (Sphere{{0, 0, -20}, 4}));
  EXPECT_EQ(std::get<std::string>(*scene.objects[0].material), "white");
  EXPECT_EQ(std::get<Sphere>(scene.objects[1].shape), (Sphere{{0, -10004, -20}, 10000}));
  const auto& floor = std::get<Finish>(std::get<Boxed<Material>>(*scene.objects[1].material)->kind);
  EXPECT_EQ(floor.color, (Color{0.2, 0.2, 0.2}));
  EXPECT_TRUE(scene.lights.empty());
  EXPECT_EQ(std::get<SphereLight>(scene.key_light->kind).radius, 3);
  EXPECT_FALSE(scene.key_light->place().has_value());
  EXPECT_EQ(std::get<Vec3d>(scene.keys.at("w")), (Vec3d{0, 25, -35}));
  EXPECT_EQ(scene.options.transfer, Transfer::linear);
}

TEST(ReadScene, MissingValuesAreTheFormatsDefaults) {
  const Scene scene = read_scene(R"({"objects":[{"type":"sphere","center":[0,0,0],"radius":1}]})");
  EXPECT_EQ(scene.background, (Color{0, 0, 0}));
  EXPECT_EQ(scene.options.transfer, Transfer::srgb);
  EXPECT_EQ(scene.options.seed, 0);
  EXPECT_FALSE(scene.objects[0].material.has_value());
  const Finish finish = std::get<Finish>(Material{}.kind);
  EXPECT_EQ(finish.color, (Color{1, 1, 1}));
  EXPECT_EQ(finish.diffuse, 1);
  EXPECT_EQ(finish.emission, (Color{0, 0, 0}));
  EXPECT_EQ(read_scene("{}"), Scene{});
}

TEST(ReadScene, LightsOfBothKindsAreRead) {
  const Scene scene = read_scene(R"({"lights":[
    {"type":"point","position":[1,2,3],"color":0.5,"intensity":2},
    {"type":"sphere","position":[4,5,6],"radius":7}]})");
  EXPECT_EQ(scene.lights[0], (Light{PointLight{Vec3d{1, 2, 3}}, {0.5, 0.5, 0.5}, 2}));
  EXPECT_EQ(scene.lights[1], (Light{SphereLight{Vec3d{4, 5, 6}, 7}, {1, 1, 1}, 1}));
}

TEST(ReadScene, KeyWithTheOneMemberLightIsAPositionAndAnyOtherAPatch) {
  const Scene scene =
      read_scene(R"({"keys":{"p":{"light":[1,2,3]},"q":{"light":[1,2,3],"title":"x"},"r":{}}})");
  EXPECT_EQ(std::get<Vec3d>(scene.keys.at("p")), (Vec3d{1, 2, 3}));
  EXPECT_TRUE(std::holds_alternative<SharedValue>(scene.keys.at("q")));
  EXPECT_TRUE(std::holds_alternative<SharedValue>(scene.keys.at("r")));
}

// ---- faults, one by one -----------------------------------------------------------------------

TEST(ReadScene, UnknownMembersNameTheNearestKnownOne) {
  expect_scene_refused(R"({"objcts":[]})", {{unknown_name, "/objcts", "\"objcts\"",
                                             "title, description, camera", "objects"}});
  expect_scene_refused(R"({"camera":{"fov":40}})",
                       {{unknown_name, "/camera/fov", "\"fov\"", "fov_degrees", "fov_degrees"}});
  expect_scene_refused(
      with_sphere(R"("colour":[1,1,1])"),
      {{unknown_name, "/objects/0/colour", "\"colour\"", "center, radius, transform, material"}});
  expect_scene_refused(
      with_sphere(R"("material":{"colour":[1,1,1]})"),
      {{unknown_name, "/objects/0/material/colour", "\"colour\"", "color", "color"}});
  expect_scene_refused(
      R"({"options":{"thread":3}})",
      {{unknown_name, "/options/thread", "\"thread\"",
        "integrator, transfer, exposure, white_balance_kelvin, samples, blur_steps, "
        "threshold, noise, max_depth, transparent_shadows, ao_radius, clamp, seed"}});
  expect_scene_refused(
      R"({"lights":[{"type":"point","position":[0,0,0],"radius":3}]})",
      {{unknown_name, "/lights/0/radius", "\"radius\"", "position, color, intensity"}});
}

TEST(ReadScene, WrongTypesSayWhatIsAllowed) {
  expect_scene_refused("[]", {{wrong_type, "", "[]", "an object"}});
  expect_scene_refused("null", {{wrong_type, "", "null", "an object"}});
  expect_scene_refused(R"({"title":5})", {{wrong_type, "/title", "5", "a string"}});
  expect_scene_refused(R"({"camera":[]})", {{wrong_type, "/camera", "[]", "an object"}});
  expect_scene_refused(R"({"objects":{}})", {{wrong_type, "/objects", "{}", "an array"}});
  expect_scene_refused(R"({"objects":[5]})", {{wrong_type, "/objects/0", "5", "an object"}});
  expect_scene_refused(R"({"background":"red"})",
                       {{wrong_type, "/background", "\"red\"", "3 numbers"}});
  expect_scene_refused(R"({"materials":[]})", {{wrong_type, "/materials", "[]", "an object"}});
  expect_scene_refused(R"({"materials":{"m":"white"}})",
                       {{wrong_type, "/materials/m", "\"white\"", "an object"}});
  expect_scene_refused(with_object(R"("type":7)"),
                       {{wrong_type, "/objects/0/type", "7", "sphere"}});
  expect_scene_refused(with_sphere(R"("material":5)"),
                       {{wrong_type, "/objects/0/material", "5", "a name or an object"}});
  expect_scene_refused(
      R"({"keys":{"a":[1,2,3]}})",
      {{wrong_type, "/keys/a", "[1,2,3]", "{\"light\": [x, y, z]} or a JSON merge patch"}});
  expect_scene_refused(R"({"keys":{"a":{"light":[1,2]}}})",
                       {{wrong_type, "/keys/a/light", "[1,2]", "3 numbers"}});
  expect_scene_refused(R"({"options":{"seed":1.5}})",
                       {{wrong_type, "/options/seed", "1.5", "an integer"}});
}

TEST(ReadScene, KindsThatDoNotExistNameTheNearestThatDoes) {
  expect_scene_refused(with_object(R"("type":"spher")"),
                       {{unknown_name, "/objects/0/type", "\"spher\"", "one of sphere", "sphere"}});
  expect_scene_refused(
      R"({"lights":[{"type":"pint"}]})",
      {{unknown_name, "/lights/0/type", "\"pint\"", "one of point, directional", "point"}});
  expect_scene_refused(
      R"({"materials":{"m":{"type":"finsh"}}})",
      {{unknown_name, "/materials/m/type", "\"finsh\"", "one of finish", "finish"}});
  expect_scene_refused(
      R"({"options":{"integrator":"tesis"}})",
      {{unknown_name, "/options/integrator", "\"tesis\"", "one of thesis", "thesis"}});
  expect_scene_refused(
      R"({"options":{"transfer":"sRGBB"}})",
      {{unknown_name, "/options/transfer", "\"sRGBB\"", "one of srgb, linear, aces, agx"}});
}

TEST(ReadScene, MissingMembersAreNamed) {
  expect_scene_refused(with_object(""), {{missing, "/objects/0/type", "", "one of sphere"}});
  expect_scene_refused(with_object(R"("type":"sphere")"),
                       {{missing, "/objects/0/center", "", "the centre"},
                        {missing, "/objects/0/radius", "", "the radius"}});
  expect_scene_refused(R"({"lights":[{}]})",
                       {{missing, "/lights/0/type", "", "one of point, directional"}});
  expect_scene_refused(R"({"lights":[{"type":"sphere","position":[0,0,0]}]})",
                       {{missing, "/lights/0/radius", "", "the radius"}});
  expect_scene_refused(R"({"key_light":{"type":"sphere"}})",
                       {{missing, "/key_light/radius", "", "the radius"}});
}

TEST(ReadScene, OnlyTheKeyLightMayWaitForItsPosition) {
  expect_scene_refused(R"({"lights":[{"type":"point"},{"type":"sphere","radius":1}]})",
                       {{missing, "/lights/0/position", "", "where the light is"},
                        {missing, "/lights/1/position", "", "where the light is"}});
  EXPECT_NO_THROW(read_scene(R"({"key_light":{"type":"point"}})"));
}

TEST(ReadScene, ValuesOutOfRangeSayTheRange) {
  const auto sphere = [](const char* radius) {
    return with_object(std::string(R"("type":"sphere","center":[0,0,0],"radius":)").append(radius));
  };
  EXPECT_NO_THROW(read_scene(sphere("1e9")));
  EXPECT_NO_THROW(read_scene(sphere("1e-300")));
  for (const char* radius : {"0", "-1", "1000000001"})
    expect_scene_refused(sphere(radius), {{out_of_range, "/objects/0/radius", radius,
                                           "above 0, at most 1000000000"}});
  expect_scene_refused(with_object(R"("type":"sphere","center":[0,-2e9,0],"radius":1)"),
                       {{out_of_range, "/objects/0/center/1", "-2000000000", "from -1000000000"}});
  expect_scene_refused(R"({"background":[0,0,-0.5]})",
                       {{out_of_range, "/background/2", "-0.5", "a number from 0 to 1000000"}});
  expect_scene_refused(R"({"materials":{"a/b~":{"diffuse":1.01}}})",
                       {{out_of_range, "/materials/a~1b~0/diffuse", "1.01", "from 0 to 1"}});
  expect_scene_refused(R"({"key_light":{"type":"point","intensity":-1}})",
                       {{out_of_range, "/key_light/intensity", "-1", "from 0 to 1000000"}});
  expect_scene_refused(R"({"keys":{"a":{"light":[1,2,1e10]}}})",
                       {{out_of_range, "/keys/a/light/2", "10000000000", "to 1000000000"}});
  for (const char* seed : {"-1", "9007199254740992"})
    expect_scene_refused(std::string(R"({"options":{"seed":)").append(seed).append("}}"),
                         {{out_of_range, "/options/seed", seed, "from 0 to 9007199254740991"}});
}

TEST(ReadScene, MaterialNamesMustExist) {
  expect_scene_refused(
      with_sphere(R"("material":"white")"),
      {{unknown_name, "/objects/0/material", "\"white\"", "the scene names none"}});
  expect_scene_refused(
      R"({"materials":{"white":{},"red":{}},"objects":[
      {"type":"sphere","center":[0,0,0],"radius":1,"material":"red"},
      {"type":"sphere","center":[0,0,0],"radius":1,"material":"whte"}]})",
      {{unknown_name, "/objects/1/material", "\"whte\"", "one of red, white", "white"}});
}

// ---- faults, many at once ---------------------------------------------------------------------

TEST(ReadScene, ManyFaultsComeAtOnce) {
  expect_scene_refused(R"({
    "title": 1, "camera": {"fov_degrees": 200, "upp": [0,1,0]}, "background": [0,0],
    "objects": [{"type":"sphere","center":[0,"0",0],"radius":-1}, {"type":"sphre"}],
    "lights": [{"type":"point","position":1}], "frobnicate": true})",
                       {{wrong_type, "/title", "1", "a string"},
                        {out_of_range, "/camera/fov_degrees", "200", "at most 179"},
                        {unknown_name, "/camera/upp", "\"upp\"", "location", "up"},
                        {wrong_type, "/background", "[0,0]", "3 numbers"},
                        {wrong_type, "/objects/0/center/1", "\"0\"", "a number"},
                        {out_of_range, "/objects/0/radius", "-1", "above 0"},
                        {unknown_name, "/objects/1/type", "\"sphre\"", "sphere", "sphere"},
                        {wrong_type, "/lights/0/position", "1", "3 numbers"},
                        {unknown_name, "/frobnicate", "\"frobnicate\"", "title"}});
}

TEST(ReadScene, FaultsAcrossFieldsComeWithTheOthers) {
  // A camera's own check is not put off by a fault before it in the text ...
  expect_scene_refused(R"({"title":1,"camera":{"direction":[0,0,0]}})",
                       {{wrong_type, "/title", "1", "a string"},
                        {out_of_range, "/camera/direction", "[0,0,0]", "some length"}});
  // ... nor a name that points nowhere by a fault beside it.
  expect_scene_refused(R"({"title":1,"objects":[
      {"type":"sphere","center":[0,0,0],"radius":1,"material":"nowhere"}]})",
                       {{wrong_type, "/title", "1", "a string"},
                        {unknown_name, "/objects/0/material", "\"nowhere\"", "names none"}});
  expect_scene_refused(R"({"title":1,"lights":[{"type":"point"}]})",
                       {{wrong_type, "/title", "1", "a string"},
                        {missing, "/lights/0/position", "", "where the light is"}});
}

TEST(ReadScene, AFaultDoesNotMakeAnother) {
  expect_scene_refused(R"({"lights":[{"type":"point","position":5}]})",
                       {{wrong_type, "/lights/0/position", "5", "3 numbers"}});
  expect_scene_refused(R"({"lights":[5]})", {{wrong_type, "/lights/0", "5", "an object"}});
  expect_scene_refused(R"({"materials":[],"objects":[
      {"type":"sphere","center":[0,0,0],"radius":1,"material":"white"}]})",
                       {{wrong_type, "/materials", "[]", "an object"}});
}

TEST(ReadScene, TwentyFaultsAreTheMostThatCome) {
  std::string members;
  for (int i = 0; i < 50; ++i)
    members.append(i > 0 ? "," : "").append("\"x").append(std::to_string(i)).append("\":0");
  const std::string json = std::string("{").append(members).append("}");
  const auto faults = test::faults_of([&] { read_scene(json); });
  ASSERT_EQ(faults.size(), 20U);
  for (std::size_t i = 0; i < 20; ++i) EXPECT_EQ(faults[i].pointer, "/x" + std::to_string(i));
}

TEST(ReadScene, MalformedTextIsOneFault) {
  expect_scene_refused(R"({"objects":[{"type":"sphere",}]})",
                       {{malformed, "/objects/0/type", "", "JSON text"}});
}

}  // namespace
}  // namespace tia
