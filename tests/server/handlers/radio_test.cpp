// Radio paths over HTTP.
#include "tests/server/support.h"

namespace tia::test {
namespace {

using testing::HasSubstr;

const std::string street = R"({"objects":[
  {"name":"street","type":"plane","point":[0,0,0],"normal":[0,1,0],
   "material":{"radio":{"type":"conductor"}}},
  {"name":"house","type":"box","min":[-5,0,10],"max":[45,9,20]}]})";
std::string radio_question(const std::string& scene, const std::string& more = "") {
  return R"({"scene":)" + scene + R"(,"transmitters":[{"name":"mast","position":[0,8,0]}],
    "receivers":[{"position":[40,2,0]}],"frequency_hz":2.4e9)" +
         more + "}";
}

TEST(RadioPathsRoute, AnswersTheWaysOfAPair) {
  const Response response = host().post("/radio/paths", radio_question(street));
  ASSERT_EQ(response.status, 200) << response.body;
  const Value told = parse_json(response.body);
  EXPECT_EQ(text_at(told, "method"), "hybrid");
  EXPECT_THAT(at(told, "assumed").as<Value::Array>()->at(0).as<std::string>()->c_str(),
              HasSubstr("house"));
  const Value pair = at(told, "pairs").as<Value::Array>()->at(0);
  EXPECT_EQ(text_at(pair, "transmitter"), "mast");
  EXPECT_EQ(number_at(pair, "receiver"), 0);
  const auto& paths = *at(pair, "paths").as<Value::Array>();
  ASSERT_EQ(paths.size(), 4U);  // straight; by the street, the house, and both
  EXPECT_NEAR(number_at(paths[0], "length_m"), std::hypot(40, 6), 1e-12);
  EXPECT_NEAR(number_at(paths[1], "length_m"), std::hypot(40, 10), 1e-12);
  EXPECT_NEAR(number_at(paths[2], "length_m"), std::hypot(40, 6, 20), 1e-12);
  const Value mirror = at(paths[1], "interactions").as<Value::Array>()->at(0);
  EXPECT_EQ(text_at(mirror, "object"), "street");
  EXPECT_EQ(text_at(mirror, "kind"), "reflection");
  EXPECT_NEAR(number_at(mirror, "angle_degrees"), std::atan2(40, 10) * 180 / pi, 1e-10);
  EXPECT_EQ(host().post("/radio/paths", radio_question(street)).body, response.body);
  const Value images =
      parse_json(host().post("/radio/paths", radio_question(street, R"(,"method":"image")")).body);
  EXPECT_EQ(at(at(images, "pairs").as<Value::Array>()->at(0), "total"), at(pair, "total"));
}

TEST(RadioPathsRoute, SaysWhatIsWrongAtItsPlace) {
  const auto pointer = [](const std::string& body) {
    return only_error(host().post("/radio/paths", body)).pointer;
  };
  EXPECT_EQ(pointer(radio_question("\"thesi\"")), "/scene");
  EXPECT_EQ(pointer(radio_question(street, R"(,"max_reflections":11)")), "/max_reflections");
  EXPECT_EQ(pointer(radio_question("\"thesis\"", R"(,"method":"image")")), "/method");
  EXPECT_EQ(pointer(R"({"scene":)" + street + R"(,"transmitters":[{"position":[0,-1,0]}],
    "receivers":[{"position":[1,1,1]}],"frequency_hz":1e9})"),
            "/transmitters/0/position");
}

// What radio is says nothing to light: pictures are the same bytes but for their recipes, and
// those of scenes without it the same in all.
TEST(RadioPathsRoute, MaterialsForRadioAreNotSeen) {
  const auto picture = [](const std::string& material) {
    return host()
        .post("/render", R"({"width":16,"height":12,"format":"pfm","scene":{"objects":[
          {"type":"sphere","center":[0,0,-5],"radius":1,"material":)" +
                             material +
                             "}],"
                             R"("lights":[{"type":"point","position":[3,3,0]}]}})")
        .body;
  };
  EXPECT_TRUE(picture(R"({"radio":{"type":"air"}})") == picture("{}"));
}

}  // namespace
}  // namespace tia::test
