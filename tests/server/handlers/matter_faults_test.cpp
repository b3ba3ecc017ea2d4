// Mistakes in the light and matter of a posted scene: the problem document points into the request.
#include "tests/server/support.h"

namespace tia::test {
namespace {

using testing::HasSubstr;

struct MatterRow {
  const char* law;
  const char* scene;  // what the request has as its scene
  const char* type;
  const char* pointer;  // below /scene
  const char* got;      // as JSON; "" = nothing came
  const char* allowed;
  const char* nearest = "";
};
void PrintTo(const MatterRow& row, std::ostream* out) { *out << row.scene; }

class MatterFault : public testing::TestWithParam<MatterRow> {
 protected:
  static void expect(const Response& response, const MatterRow& row, const std::string& above) {
    EXPECT_EQ(response.status, 422);
    EXPECT_EQ(problem_of(response).type, std::string("/problems/") + row.type);
    const ProblemError error = only_error(response);
    EXPECT_EQ(error.pointer, above + row.pointer);
    EXPECT_EQ(error.got ? to_json(*error.got) : "", row.got);
    EXPECT_THAT(error.allowed, HasSubstr(row.allowed));
    EXPECT_EQ(error.nearest, row.nearest);
  }
};

TEST_P(MatterFault, IsNamedWhereverTheSceneGoes) {
  const MatterRow& row = GetParam();
  const std::string scene = row.scene;
  expect(host().post("/render", R"({"scene":)" + scene + "}"), row, "/scene");
  expect(host().post("/explain", R"({"x":1,"y":1,"scene":)" + scene + "}"), row, "/scene");
  expect(host().post("/scenes", scene), row, "");
  expect(host().get("/render?scene=" + url_encode(scene)), row, "/scene");
}

const MatterRow light_rows[] = {
    {"Kind", R"({"lights":[{"type":"spott"}]})", "unknown-name", "/lights/0/type", R"("spott")",
     "one of point, directional", "spot"},
    {"NoDirection", R"({"lights":[{"type":"directional","direction":[0,0,0]}]})", "out-of-range",
     "/lights/0/direction", "[0,0,0]", "a direction of some length"},
    {"SpotAtItself", R"({"lights":[{"type":"spot","position":[1,2,3],"point_at":[1,2,3]}]})",
     "out-of-range", "/lights/0/point_at", "[1,2,3]", "a point other than position"},
    {"FalloffWithinRadius",
     R"({"lights":[{"type":"spot","position":[1,2,3],"radius_degrees":60,"falloff_degrees":50}]})",
     "out-of-range", "/lights/0/falloff_degrees", "50", "from radius_degrees, 60, to 180"},
    {"Radius", R"({"lights":[{"type":"sphere","position":[0,9,0],"radius":-1}]})", "out-of-range",
     "/lights/0/radius", "-1", "above 0"},
    {"NoSamples", R"({"lights":[{"type":"sphere","position":[0,9,0],"radius":1,"samples":0}]})",
     "out-of-range", "/lights/0/samples", "0", "an integer from 1 to 4096"},
    {"TooManySamples",
     R"({"lights":[{"type":"quad","corner":[0,9,0],"u":[1,0,0],"v":[0,0,1],"samples":65536}]})",
     "out-of-range", "/lights/0/samples", "65536", "an integer from 1 to 4096"},
    {"FlatQuad", R"({"lights":[{"type":"quad","corner":[0,9,0],"u":[1,0,0],"v":[-2,0,0]}]})",
     "out-of-range", "/lights/0/v", "[-2,0,0]", "spans an area with u"},
    {"KeyLight", R"({"key_light":{"type":"sphere","radius":1,"colour":1}})", "unknown-name",
     "/key_light/colour", R"("colour")", "color", "color"},
    {"FadingSun", R"({"lights":[{"type":"directional","direction":[0,-1,0],"fade_distance":9}]})",
     "conflict", "/lights/0/fade_distance", "9", "at some distance"},
};

const MatterRow matter_rows[] = {
    {"Reflection", R"({"materials":{"m":{"reflection":1.5}}})", "out-of-range",
     "/materials/m/reflection", "1.5", "a number from 0 to 1"},
    {"NoIndex", R"({"materials":{"m":{"ior":0}}})", "out-of-range", "/materials/m/ior", "0",
     "from 0.1 to 10"},
    {"NegativeIndex", R"({"materials":{"m":{"ior":-1.5}}})", "out-of-range", "/materials/m/ior",
     "-1.5", "from 0.1 to 10"},
    {"Word", R"({"materials":{"m":{"rougness":0.1}}})", "unknown-name", "/materials/m/rougness",
     R"("rougness")", "roughness", "roughness"},
    {"Texture", R"({"materials":{"m":{"texture":{"type":"maple"}}}})", "unknown-name",
     "/materials/m/texture/type", R"("maple")", "checker, stripes, gradient, noise, marble, wood",
     "marble"},
    {"NoColors", R"({"materials":{"m":{"texture":{"type":"noise","colors":[]}}}})", "wrong-type",
     "/materials/m/texture/colors", "[]", "at least 2"},
    {"TextureWithoutRange",
     R"({"materials":{"m":{"type":"principled","roughness":{"type":"checker"}}}})", "missing",
     "/materials/m/roughness/range", "", "2 numbers, each a number from 0 to 1"},
    {"NotBase64", R"({"materials":{"m":{"texture":{"type":"image","data":"data:,x"}}}})",
     "wrong-type", "/materials/m/texture/data", R"(":,x")", "not from its character 4 on"},
    {"NotAPicture", R"({"materials":{"m":{"texture":{"type":"image","data":"R0lGODlh"}}}})",
     "wrong-type", "/materials/m/texture/data", R"("bytes that begin like neither")",
     "a whole PNG or JPEG picture"},
    {"HalfAPicture",
     R"({"materials":{"m":{"texture":{"type":"image","data":
        "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVR42mP4"}}}})",
     "wrong-type", "/materials/m/texture/data", R"("bytes that cannot be decoded")",
     "a whole PNG or JPEG picture"},
};

const MatterRow option_rows_of_scenes[] = {
    {"MaxDepth", R"({"options":{"max_depth":65}})", "out-of-range", "/options/max_depth", "65",
     "an integer from 0 to 64"},
    {"TransparentShadows", R"({"options":{"transparent_shadows":1}})", "wrong-type",
     "/options/transparent_shadows", "1", "true or false"},
    {"Seed", R"({"options":{"seed":9007199254740992}})", "out-of-range", "/options/seed",
     "9007199254740992", "from 0 to 9007199254740991"},
    {"AmbientLight", R"({"ambient_light":-1})", "out-of-range", "/ambient_light", "-1",
     "from 0 to 1000000"},
};

INSTANTIATE_TEST_SUITE_P(Lights, MatterFault, testing::ValuesIn(light_rows), law_of);
INSTANTIATE_TEST_SUITE_P(Matter, MatterFault, testing::ValuesIn(matter_rows), law_of);
INSTANTIATE_TEST_SUITE_P(Options, MatterFault, testing::ValuesIn(option_rows_of_scenes), law_of);

// A directional key light shines from the given position towards the point looked at: at that point
// itself it has no direction.
TEST(MatterFaults, DirectionalKeyLightAtThePointLookedAtHasNoDirection) {
  Host host;
  const Response response =
      host.post("/explain", R"({"x":4,"y":4,"width":8,"height":8,"light":[0,0,0],"scene":{
        "camera":{"location":[0,1,5],"look_at":[0,0,0]},
        "objects":[{"type":"sphere","center":[0,0,0],"radius":1}],
        "key_light":{"type":"directional"}}})");
  EXPECT_EQ(response.status, 422);
  EXPECT_EQ(response.body.find("[null,null,null]"), std::string::npos) << response.body;
}

// ---- what would never end ----------------------------------------------------------------------

// Glass in glass: each surface parts each ray in two.
std::string nested_glass(int balls) {
  std::string list;
  for (int i = 0; i < balls; ++i)
    list += std::string(i > 0 ? "," : "") + R"({"type":"sphere","center":[0,0,-50],"radius":)" +
            std::to_string(2 + i) + R"(,"material":{"diffuse":0,"transmission":1,"fresnel":true,)" +
            R"("ior":)" + (i % 2 == 0 ? "1.3" : "1.8") + "}}";
  return R"({"objects":[)" + list + "]}";
}

TEST(MatterLimits, RaysThatPartWithoutEndAreStoppedByTheirNumber) {
  Config config;
  config.max_rays = 300'000;
  Host host(config);
  const std::string asked =
      R"({"width":16,"height":16,"max_depth":64,"scene":)" + nested_glass(12) + "}";
  const Response response = host.post("/render", asked);
  EXPECT_EQ(response.status, 422);
  EXPECT_EQ(problem_of(response).type, "/problems/limit");
  EXPECT_THAT(only_error(response).allowed, HasSubstr("300000 rays (option TIA_MAX_RAYS)"));
  EXPECT_EQ(host.post("/render", R"({"width":8,"height":8})").status, 200) << "it lives on";
}

TEST(MatterLimits, TreesTooLargeForAnAnswerAreStopped) {
  Host host;
  const Response response =
      host.post("/explain", R"({"x":8,"y":8,"width":16,"height":16,"max_depth":64,"scene":)" +
                                nested_glass(12) + "}");
  EXPECT_EQ(response.status, 422);
  EXPECT_EQ(problem_of(response).type, "/problems/limit");
  EXPECT_THAT(only_error(response).allowed, HasSubstr("rays"));
}

// Each light and each of its places takes time at each point, above the surface or below it.
TEST(MatterLimits, PlacesOfLightsBelowTheSurfaceCostToo) {
  Config config;
  config.max_work = 1'000'000;
  config.max_rays = 1'000'000;
  Host host(config);
  std::string list;
  for (int i = 0; i < 20; ++i)
    list += std::string(i > 0 ? "," : "") + R"({"type":"sphere","radius":1,"samples":4096,)" +
            R"("position":[0,)" + std::to_string(-5 - 3 * i) + ",0]}";
  const Response response = host.post("/render", R"({"width":64,"height":64,"scene":{
        "camera":{"location":[0,5,0],"direction":[0,-1,0],"up":[0,0,-1]},
        "objects":[{"type":"plane","point":[0,0,0],"normal":[0,1,0]}],"lights":[)" +
                                                     list + "]}}");
  EXPECT_EQ(response.status, 422) << "335 million places were looked at";
}

TEST(MatterLimits, AnswersHaveAsManyTermsAsFitToo) {
  // A room of mirrors: 65 rays, each with a term for each of 5000 lights.
  Host host;
  std::string list;
  for (int i = 0; i < 5000; ++i)
    list += std::string(i > 0 ? "," : "") + R"({"type":"point","position":[0,0.5,0]})";
  const Response response =
      host.post("/explain", R"({"x":8,"y":8,"width":16,"height":16,"max_depth":64,"scene":{
        "camera":{"location":[0.1,0.2,0.3],"look_at":[0,0,-1]},
        "objects":[{"type":"box","min":[-1,-1,-1],"max":[1,1,1],"material":{"reflection":1}}],
        "lights":[)" + list + "]}}");
  EXPECT_LT(response.body.size(), 16U << 20U) << "bytes";
}

}  // namespace
}  // namespace tia::test
