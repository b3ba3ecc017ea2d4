// Each error row of /render, asked by GET and by POST: both give the same problem document.
#include "tests/server/support.h"

namespace tia::test {
namespace {

using testing::HasSubstr;

struct ParameterRow {
  const char* law;
  const char* json;  // the parameters; the query is made of them
  const char* type;
  const char* pointer;
  const char* got;  // as JSON; "" = nothing came
  const char* allowed;
  const char* nearest = "";
};
void PrintTo(const ParameterRow& row, std::ostream* out) { *out << row.json; }

class RenderFault : public testing::TestWithParam<ParameterRow> {};

TEST_P(RenderFault, IsNamedAlikeByGetAndPost) {
  const ParameterRow& row = GetParam();
  const Response post = host().post("/render", row.json);
  const Response get = host().get(std::string("/render?") + query_of(parse_json(row.json)));
  EXPECT_EQ(get.status, 422);
  EXPECT_EQ(get.body, post.body);
  EXPECT_EQ(post.status, 422);
  EXPECT_EQ(problem_of(post).type, std::string("/problems/") + row.type);
  EXPECT_EQ(problem_of(post).instance, Host::id);
  const ProblemError error = only_error(post);
  EXPECT_EQ(error.pointer, row.pointer);
  EXPECT_EQ(error.got ? to_json(*error.got) : "", row.got);
  EXPECT_THAT(error.allowed, HasSubstr(row.allowed));
  EXPECT_EQ(error.nearest, row.nearest);
}

TEST_P(RenderFault, IsFoundByHeadToo) {
  EXPECT_EQ(host().head(std::string("/render?") + query_of(parse_json(GetParam().json))).status,
            422);
}

const ParameterRow name_rows[] = {
    {"UnknownParameter", R"({"widh":8})", "unknown-name", "/widh", R"("widh")",
     "scene, key, light, width, height", "width"},
    {"UnknownParameterFarFromAny", R"({"colour":"red"})", "unknown-name", "/colour", R"("colour")",
     "scene, key, light, width, height"},
    {"EmptyName", R"({"":5})", "unknown-name", "/", R"("")", "width"},
    {"NameWithSlashAndTilde", R"({"a/b~c":5})", "unknown-name", "/a~1b~0c", R"("a/b~c")", "width"},
    {"UnknownScene", R"({"scene":"thesi"})", "unknown-name", "/scene", R"("thesi")", "thesis",
     "thesis"},
    {"UnknownKey", R"({"key":"q"})", "unknown-name", "/key", R"("q")", "a, d, s, w"},
    {"EmptyKey", R"({"key":""})", "unknown-name", "/key", R"("")", "a, d, s, w"},
    {"KeyIsCaseSensitive", R"({"key":"A"})", "unknown-name", "/key", R"("A")", "a, d, s, w"},
    {"UnknownFormat", R"({"format":"pgn"})", "unknown-name", "/format", R"("pgn")",
     "png, pfm, hdr, tiff, exr", "png"},
    {"UnknownLayer", R"({"format":"exr","aov":["Z","normals"]})", "unknown-name", "/aov/1",
     R"("normals")", "rgba, normal, albedo, Z, object", "normal"},
    {"UnknownTransfer", R"({"transfer":"srbg"})", "unknown-name", "/transfer", R"("srbg")",
     "srgb, linear, aces, agx", "srgb"},
    {"UnknownIntegrator", R"({"integrator":"thesys"})", "unknown-name", "/integrator",
     R"("thesys")", "thesis", "thesis"},
};

const ParameterRow value_rows[] = {
    {"KeyWithLight", R"({"key":"a","light":[1,2,3]})", "conflict", "/light", "[1,2,3]",
     "key or light"},
    {"LightOfTwo", R"({"light":[1,2]})", "wrong-type", "/light", "[1,2]", "3 numbers"},
    {"LightOfWords", R"({"light":"over there"})", "wrong-type", "/light", R"("over there")",
     "3 numbers"},
    {"LightTooFar", R"({"light":[1,2,1e10]})", "out-of-range", "/light/2", "10000000000",
     "1000000000"},
    {"CropOfThree", R"({"crop":[0,0,8]})", "wrong-type", "/crop", "[0,0,8]", "4 numbers"},
    {"CropNegative", R"({"crop":[-1,0,8,8]})", "out-of-range", "/crop/0", "-1", "from 0"},
    {"CropFraction", R"({"crop":[0,0.5,8,8]})", "wrong-type", "/crop/1", "0.5", "an integer"},
    {"CropEmpty", R"({"crop":[5,5,5,9]})", "out-of-range", "/crop", "[5,5,5,9]", "x0 < x1"},
    {"CropTurnedRound", R"({"crop":[0,9,8,8]})", "out-of-range", "/crop", "[0,9,8,8]", "y0 < y1"},
    {"CropBeyondWidth", R"({"width":8,"height":8,"crop":[0,0,9,8]})", "out-of-range", "/crop",
     "[0,0,9,8]", "x1 <= 8"},
    {"CropBeyondHeight", R"({"width":8,"height":8,"crop":[0,0,8,9]})", "out-of-range", "/crop",
     "[0,0,8,9]", "y1 <= 8"},
    {"ThreadsZero", R"({"threads":0})", "out-of-range", "/threads", "0", "from 1 to 64"},
    {"ThreadsBeyond", R"({"threads":65})", "out-of-range", "/threads", "65", "from 1 to 64"},
    {"SamplesZero", R"({"samples":0})", "out-of-range", "/samples", "0", "from 1 to 65536"},
    {"SamplesBeyond", R"({"samples":65537})", "out-of-range", "/samples", "65537",
     "from 1 to 65536"},
    {"SamplesFraction", R"({"samples":1.5})", "wrong-type", "/samples", "1.5", "an integer"},
    {"ThresholdNegative", R"({"threshold":-0.1})", "out-of-range", "/threshold", "-0.1",
     "from 0 to 1"},
    {"ThresholdBeyond", R"({"threshold":1.1})", "out-of-range", "/threshold", "1.1", "from 0 to 1"},
    {"ExposureBeyond", R"({"exposure":32.5})", "out-of-range", "/exposure", "32.5",
     "from -32 to 32"},
    {"ExposureOfWords", R"({"exposure":"+1"})", "wrong-type", "/exposure", R"("+1")", "stops"},
    {"WhiteTooCold", R"({"white_balance_kelvin":999})", "out-of-range", "/white_balance_kelvin",
     "999", "from 1000 to 25000"},
    {"WhiteTooHot", R"({"white_balance_kelvin":25001})", "out-of-range", "/white_balance_kelvin",
     "25001", "from 1000 to 25000"},
    {"NoiseBeyond", R"({"integrator":"path","noise":1.5})", "out-of-range", "/noise", "1.5",
     "from 0 to 1"},
    {"NoiseWithoutChance", R"({"integrator":"whitted","noise":0.1})", "conflict", "/noise", "0.1",
     "(ambient_occlusion or path); this picture's is whitted"},
    {"NoiseWithThreshold", R"({"integrator":"path","noise":0.1,"threshold":0.1})", "conflict",
     "/noise", "0.1", "noise or threshold"},
    {"DenoiseOfFeatures", R"({"integrator":"depth","denoise":true,"samples":4})", "conflict",
     "/denoise", "true", "an integrator that gathers light; this picture's is depth"},
    {"DenoiseOfOneSample", R"({"integrator":"whitted","denoise":true})", "conflict", "/denoise",
     "true", "more than one sample a pixel"},
    {"BudgetWithoutChance", R"({"budget_ms":100})", "conflict", "/budget_ms", "100",
     "ambient_occlusion or path"},
    {"BudgetWithThreshold", R"({"integrator":"path","budget_ms":100,"threshold":0.1})", "conflict",
     "/budget_ms", "100", "budget_ms or threshold"},
    {"BudgetOfNoTime", R"({"integrator":"path","budget_ms":0})", "out-of-range", "/budget_ms", "0",
     "from 1 to 3600000"},
    {"RaysWithoutChance", R"({"max_rays":100})", "conflict", "/max_rays", "100",
     "ambient_occlusion or path"},
    {"LayersOfPng", R"({"aov":["Z"]})", "conflict", "/aov", R"(["Z"])",
     "aov with format exr; this picture's is png"},
    {"LayerTwice", R"({"format":"exr","aov":["Z","rgba","Z"]})", "conflict", "/aov/2", R"("Z")",
     "each layer once"},
    {"LayerUnknown", R"({"format":"exr","aov":["depth"]})", "unknown-name", "/aov/0", R"("depth")",
     "one of rgba, normal, albedo, Z"},
    {"PartsOfNoPath", R"({"format":"exr","aov":["rgba","direct"]})", "conflict", "/aov/1",
     R"("direct")", "integrator path, whose light is parted; this picture's is thesis"},
    {"VarianceOfOne", R"({"format":"exr","aov":["variance"]})", "conflict", "/aov/0",
     R"("variance")", "at least 2 samples"},
    {"VarianceWithThreshold", R"({"format":"exr","aov":["variance"],"samples":4,"threshold":0.1})",
     "conflict", "/aov/0", R"("variance")", "without threshold"},
    {"DepthOfPng", R"({"depth":16})", "conflict", "/depth", "16", "depth with format exr"},
    {"DepthBetween", R"({"format":"exr","depth":24})", "out-of-range", "/depth", "24", "16 or 32"},
    {"CameraOfWords", R"({"camera":"above"})", "wrong-type", "/camera", R"("above")", "an object"},
    {"CameraUnknownField", R"({"camera":{"fov":30}})", "unknown-name", "/camera/fov", R"("fov")",
     "fov_degrees", "fov_degrees"},
    {"CameraUnknownFieldRemoved", R"({"camera":{"fov":null}})", "unknown-name", "/camera/fov",
     R"("fov")", "fov_degrees", "fov_degrees"},
    {"CameraAngle", R"({"camera":{"fov_degrees":180}})", "out-of-range", "/camera/fov_degrees",
     "180", "179"},
    {"CameraPoint", R"({"camera":{"location":[0,0]}})", "wrong-type", "/camera/location", "[0,0]",
     "3 numbers"},
    {"CameraConflict", R"({"camera":{"direction":[0,0,-1]}})", "conflict", "/camera/direction",
     "[0,0,-1]", "look_at or direction"},
    {"CameraIncomplete", R"({"camera":{"aperture":1}})", "missing", "/camera/focus_distance", "",
     "aperture"},
    {"CameraLooksNowhere", R"({"camera":{"look_at":[0,0,0]}})", "out-of-range", "/camera/look_at",
     "[0,0,0]", "other than location"},
    {"SeedNegative", R"({"seed":-1})", "out-of-range", "/seed", "-1", "9007199254740991"},
    {"SeedBeyond", R"({"seed":9007199254740992})", "out-of-range", "/seed", "9007199254740992",
     "9007199254740991"},
};

const ParameterRow scene_rows[] = {
    {"Radius", R"({"scene":{"objects":[{"type":"sphere","center":[0,0,-5],"radius":0}]}})",
     "out-of-range", "/scene/objects/0/radius", "0", "above 0"},
    {"MissingRadius", R"({"scene":{"objects":[{"type":"sphere","center":[0,0,-5]}]}})", "missing",
     "/scene/objects/0/radius", "", "radius"},
    {"MissingType", R"({"scene":{"objects":[{"center":[0,0,-5],"radius":1}]}})", "missing",
     "/scene/objects/0/type", "", "sphere"},
    {"ObjectType", R"({"scene":{"objects":[{"type":"spere","center":[0,0,-5],"radius":1}]}})",
     "unknown-name", "/scene/objects/0/type", R"("spere")", "sphere", "sphere"},
    {"SceneKey", R"({"scene":{"object":[]}})", "unknown-name", "/scene/object", R"("object")",
     "objects", "objects"},
    {"CameraKey", R"({"scene":{"camera":{"fov":30}}})", "unknown-name", "/scene/camera/fov",
     R"("fov")", "fov_degrees", "fov_degrees"},
    {"Material",
     R"({"scene":{"materials":{"white":{}},"objects":[
         {"type":"sphere","center":[0,0,-5],"radius":1,"material":"whit"}]}})",
     "unknown-name", "/scene/objects/0/material", R"("whit")", "white", "white"},
    {"LightWithoutPlace", R"({"scene":{"lights":[{"type":"point"}]}})", "missing",
     "/scene/lights/0/position", "", "where"},
    {"Background", R"({"scene":{"background":[0,-1,0]}})", "out-of-range", "/scene/background/1",
     "-1", "0"},
    {"KeyOfScene", R"({"scene":{"keys":{"x":{"light":[1,2,3]}}},"key":"a"})", "unknown-name",
     "/key", R"("a")", "x"},
};

INSTANTIATE_TEST_SUITE_P(Names, RenderFault, testing::ValuesIn(name_rows), law_of);
INSTANTIATE_TEST_SUITE_P(Values, RenderFault, testing::ValuesIn(value_rows), law_of);
INSTANTIATE_TEST_SUITE_P(Scenes, RenderFault, testing::ValuesIn(scene_rows), law_of);

// ---- numbers: every field of pixels, swept -----------------------------------------------------

struct Number {
  const char* text;
  const char* type;
  const char* got;
};
const Number bad_sizes[] = {
    {"0", "out-of-range", "0"},
    {"-0", "out-of-range", "0"},
    {"-1", "out-of-range", "-1"},
    {"1.5", "wrong-type", "1.5"},
    {"1.9", "wrong-type", "1.9"},
    {"5e-324", "wrong-type", "5e-324"},
    {"1e9", "out-of-range", "1000000000"},
    {"16777217", "out-of-range", "16777217"},
    {"2147483648", "out-of-range", "2147483648"},
    {"4294967297", "out-of-range", "4294967297"},
    {"18446744073709551617", "out-of-range", "18446744073709552000"},
    {"1e308", "out-of-range", "1e+308"},
    {"\"abc\"", "wrong-type", "\"abc\""},
    {"\"8px\"", "wrong-type", "\"8px\""},
    {"\"NaN\"", "wrong-type", "\"NaN\""},
    {"\"Infinity\"", "wrong-type", "\"Infinity\""},
    {"\"0x10\"", "wrong-type", "\"0x10\""},
    {"\"\"", "wrong-type", "\"\""},
    {"\"1e400\"", "wrong-type", "\"1e400\""},
};

class RenderSize : public testing::TestWithParam<const char*> {};

TEST_P(RenderSize, RefusesWhatIsNoNumberOfPixels) {
  Host host;
  for (const Number& bad : bad_sizes) {
    const std::string json = std::string("{\"").append(GetParam()) + "\":" + bad.text + "}";
    SCOPED_TRACE(json);
    std::string plain = bad.text;  // as a query has it: no quotes
    std::erase(plain, '"');
    const Response post = host.post("/render", json);
    const Response get = host.get(std::string("/render?").append(GetParam()) + "=" + plain);
    EXPECT_EQ(post.status, 422);
    EXPECT_EQ(get.body, post.body);
    EXPECT_EQ(problem_of(post).type, std::string("/problems/") + bad.type);
    const ProblemError error = only_error(post);
    EXPECT_EQ(error.pointer, std::string("/").append(GetParam()));
    EXPECT_EQ(error.got ? to_json(*error.got) : "nothing", bad.got);
    EXPECT_THAT(error.allowed, HasSubstr("an integer from 1 to 16777216 (pixels)"));
  }
}

std::string field_name(const testing::TestParamInfo<const char*>& info) { return info.param; }
INSTANTIATE_TEST_SUITE_P(Of, RenderSize, testing::Values("width", "height"), field_name);

}  // namespace
}  // namespace tia::test
