// Pictures that are sent back: drawn again, or held against what this version draws.
#include "server/requests/recipe.h"

#include <map>
#include <set>

#include "core/film/png.h"
#include "server/stores/digest.h"
#include "tests/core/film/files.h"
#include "tests/server/http/reader_support.h"
#include "tests/server/requests/recipe_support.h"

namespace tia::test {
namespace {

Response sent_back(const std::string& png) { return host().post("/render", png, "image/png"); }
Response verified(const std::string& png) { return host().post("/verify", png, "image/png"); }
std::string verdict_on(const std::string& png) {
  return text_at(parse_json(verified(png).body), "verdict");
}
std::string picture(const std::string& query = "") {
  return host().get("/render?width=24&height=18&" + query).body;
}
// The recipe with one text of it replaced.
std::string changed(const std::string& png, const std::string& from, const std::string& to) {
  std::string text = recipe_text(png);
  const auto at = text.find(from);
  EXPECT_NE(at, text.npos) << from << " in " << text;
  return with_recipe(png, text.replace(at, from.size(), to));
}

// ---- drawn again ----------------------------------------------------------------------------

TEST(Recipe, EveryGalleryPictureIsDrawnAgainFromItself) {
  Config config;
  config.cache_bytes = 0;
  Host host(config);
  const std::vector<std::string_view> names = host.gallery().names();
  const std::string rays = sanitized() ? "&samples=1&threshold=0" : "";
  for (std::size_t i = 0; i < names.size(); i += sanitized() ? 5 : 1) {
    const std::string_view name = names[i];
    SCOPED_TRACE(name);
    const Response drawn = host.get("/render?width=16&height=12&scene=" + std::string(name) + rays);
    ASSERT_EQ(drawn.status, 200);
    const Response again = host.post("/render", drawn.body, "image/png");
    ASSERT_EQ(again.status, 200) << again.body;
    EXPECT_TRUE(again.body == drawn.body);
    EXPECT_EQ(header(again, "ETag"), header(drawn, "ETag"));
  }
}

TEST(Recipe, EveryParameterIsInIt) {
  Config config;
  config.cache_bytes = 0;
  Host other(config);
  for (const char* query :
       {"key=w", "light=1,20,3", "samples=3&seed=9", "threshold=0.05", "integrator=depth",
        "integrator=object&samples=4", "max_depth=0&scene=whitted",
        "integrator=ambient_occlusion&ao_radius=2&threshold=0.1&scene=shapes", "crop=3,4,11,17",
        "integrator=ambient_occlusion&samples=4&denoise=true&crop=2,3,9,8",
        "scene=shapes&integrator=path&noise=0.05&samples=100",
        "transfer=agx&exposure=1.5&white_balance_kelvin=3200",
        "camera=%7B%22fov_degrees%22:30%7D&key=a", "threads=2&v=0.4.2",
        "scene=%7B%22background%22:0.5,%22title%22:%22t%C3%ACa%22%7D"}) {
    SCOPED_TRACE(query);
    const std::string drawn = picture(query);
    const Response again = other.post("/render", drawn, "image/png");
    ASSERT_EQ(again.status, 200) << again.body;
    EXPECT_TRUE(again.body == drawn);
  }
}

struct FieldNames {
  std::vector<std::string> names = {};
  template <class Base, class Member>
  void operator()(std::string_view name, Member Base::*, const Spec&) {
    names.emplace_back(name);
  }
};

// What a recipe did not tell, the cache would not tell apart.
TEST(Recipe, ChangesWithEveryParameterThatChangesThePicture) {
  const std::map<std::string, std::string> other{
      {"scene", "whitted"},    {"key", "a"},      {"light", "1,20,3"},
      {"width", "17"},         {"height", "13"},  {"camera", "%7B%22fov_degrees%22:30%7D"},
      {"integrator", "depth"}, {"samples", "2"},  {"threshold", "0.1"},
      {"max_depth", "1"},      {"seed", "5"},     {"crop", "1,2,3,4"},
      {"transfer", "srgb"},    {"format", "pfm"}, {"ao_radius", "2"},
      {"exposure", "1"},       {"noise", "0.1"},  {"white_balance_kelvin", "3000"},
      {"depth_range", "1,2"},  {"aov", "normal"}, {"depth", "32"},
      {"denoise", "true"},     {"time", "1"},     {"frame", "3"},
      {"blur_steps", "2"},     {"gaze", "3,4"},   {"acuity", "%7B%22slope%22:0.1%7D"},
      {"gaze_rays", "90"}};
  const std::string moves =
      "%7B%22animation%22:%7B%22duration%22:2,%22shutter%22:1,%22tracks%22:[%7B%22target%22:%22/"
      "background%22,"
      "%22formula%22:%22t/2%22%7D]%7D%7D";
  const std::set<std::string> of_no_byte{"threads", "v"};
  // What ends a picture early is not told, but what it came to (Rounds).
  const std::set<std::string> of_time{"budget_ms", "max_rays", "frame_ms"};
  // What has an effect only beside another one.
  const std::map<std::string, std::map<std::string, std::string>> beside{
      {"ao_radius", {{"integrator", "ambient_occlusion"}}},
      {"noise", {{"integrator", "ambient_occlusion"}}},
      {"depth_range", {{"integrator", "planar_depth"}, {"format", "tiff"}}},
      {"aov", {{"format", "exr"}}},
      {"depth", {{"format", "exr"}}},
      {"denoise", {{"integrator", "ambient_occlusion"}}},
      {"blur_steps", {{"scene", moves}, {"samples", "4"}, {"time", "1"}}},
      {"gaze_rays", {{"gaze", "3,4"}}},
      {"acuity", {{"gaze", "3,4"}}},
      {"time", {{"scene", moves}}},
      {"frame", {{"scene", moves}}}};
  FieldNames fields;
  PictureRequest::fields(fields);
  const auto tag = [](std::map<std::string, std::string> query) {
    query.try_emplace("width", "16");
    query.try_emplace("height", "12");
    std::string target = "/render?";
    for (const auto& [name, value] : query) target.append(name).append("=").append(value) += '&';
    return header(host().get(target.substr(0, target.size() - 1)), "ETag");
  };
  for (const std::string& name : fields.names) {
    if (of_no_byte.contains(name) || of_time.contains(name)) continue;
    ASSERT_TRUE(other.contains(name)) << name << " is new: give it a value here";
    std::map<std::string, std::string> query;
    if (beside.contains(name)) query = beside.at(name);
    const auto usual = tag(query);
    query[name] = other.at(name);
    const auto changed = tag(query);
    ASSERT_TRUE(changed) << name;
    EXPECT_NE(changed, usual) << name;
  }
}

TEST(Recipe, IsCanonicalTextThatRenderTakesAsJson) {
  const std::string drawn = picture("key=a&samples=2"), text = recipe_text(drawn);
  const Value recipe = parse_json(text);
  EXPECT_EQ(to_json(recipe), text);
  EXPECT_EQ(text_at(recipe, "version"), full_version());
  EXPECT_TRUE(host().post("/render", to_json(at(recipe, "request"))).body == drawn);
}

TEST(Recipe, OfAPictureOfAKeptSceneNeedsTheSceneNoMore) {
  Host keeper;
  const std::string id = text_at(
      parse_json(keeper.post("/scenes", R"({"background":[0.25,0.5,1],"title":"kept"})").body),
      "id");
  const std::string drawn = keeper.get("/render?width=9&height=7&scene=" + id).body;
  EXPECT_TRUE(sent_back(drawn).body == drawn);
}

TEST(Recipe, IsTakenWhateverTheBodySaysItIs) {
  const std::string drawn = picture();
  for (const char* type : {"application/x-www-form-urlencoded", "", "application/json"})
    EXPECT_TRUE(host().post("/render", drawn, type).body == drawn) << type;
}

TEST(Recipe, OfALargePictureThatIsCutInStripsIsThereToo) {
  const std::string drawn = host().get("/render?width=800&height=600").body;
  EXPECT_EQ(verdict_on(drawn), "same");
}

// ---- held against what is drawn -------------------------------------------------------------

TEST(Verify, SaysSameOfWhatThisVersionDraws) {
  const std::string drawn = picture("key=a");
  const Response response = verified(drawn);
  ASSERT_EQ(response.status, 200);
  const Value told = parse_json(response.body);
  EXPECT_EQ(text_at(told, "verdict"), "same");
  EXPECT_EQ(text_at(told, "sha256"), sha256_hex(drawn));
  EXPECT_EQ(text_at(told, "expected_sha256"), sha256_hex(drawn));
  EXPECT_EQ(text_at(told, "version"), full_version());
  EXPECT_EQ(text_at(told, "drawn_by"), full_version());
  EXPECT_EQ(at(told, "request"), at(parse_json(recipe_text(drawn)), "request"));
}

TEST(Verify, SaysDifferentOfWhatIsForged) {
  const std::string drawn = picture("key=a"), other = picture("key=d");
  const std::string forged[] = {with_recipe(drawn, recipe_text(other)),
                                changed(drawn, "\"width\":24", "\"width\":25"),
                                with_recipe(drawn, recipe_text(drawn) + " ")};
  for (const std::string& each : forged) {
    EXPECT_EQ(verdict_on(each), "different");
    EXPECT_NE(text_at(parse_json(verified(each).body), "expected_sha256"), sha256_hex(each));
  }
}

TEST(Verify, CannotTellOfWhatAnotherVersionHasDrawn) {
  const std::string old = changed(picture(), full_version(), "0.0.1+zlib-1.2");
  const Value told = parse_json(verified(old).body);
  EXPECT_EQ(text_at(told, "verdict"), "other-version");
  EXPECT_EQ(text_at(told, "drawn_by"), "0.0.1+zlib-1.2");
  EXPECT_EQ(find(*told.as<Value::Object>(), "expected_sha256"), nullptr);
  const ProblemError refused = only_error(sent_back(old));
  EXPECT_EQ(refused.pointer, "/version");
  EXPECT_EQ(refused.got, Value("0.0.1+zlib-1.2"));
  EXPECT_THAT(refused.allowed, testing::HasSubstr(full_version()));
}

// ---- refused --------------------------------------------------------------------------------

struct Broken {
  const char* law;
  std::string body;
  int status;
  const char* type;
  const char* pointer;
};
void PrintTo(const Broken& broken, std::ostream* out) { *out << broken.law; }

class BrokenPicture : public testing::TestWithParam<Broken> {};

TEST_P(BrokenPicture, IsRefusedByRenderAndVerify) {
  const Broken& broken = GetParam();
  for (const Response& response : {sent_back(broken.body), verified(broken.body)}) {
    EXPECT_EQ(response.status, broken.status);
    const Problem problem = problem_of(response);
    EXPECT_EQ(problem.type, std::string("/problems/") + broken.type);
    ASSERT_FALSE(problem.errors.empty());
    EXPECT_EQ(problem.errors.front().pointer, broken.pointer);
  }
}

std::vector<Broken> broken_pictures() {
  const std::string drawn = picture();
  std::string flipped = drawn;
  flipped[drawn.size() / 2] = static_cast<char>(flipped[drawn.size() / 2] ^ 1);
  return {{"WithoutARecipe", without_recipe(drawn), 422, "missing", ""},
          {"CutShort", drawn.substr(0, drawn.size() - 1), 400, "malformed", ""},
          {"NothingButASignature", drawn.substr(0, 8), 400, "malformed", ""},
          {"Flipped", flipped, 400, "malformed", ""},
          {"WithBytesBehindItsEnd", drawn + "x", 400, "malformed", ""},
          {"WhoseRecipeIsNoJson", with_recipe(drawn, "{"), 400, "malformed", ""},
          {"WhoseRecipeIsNone", with_recipe(drawn, "{}"), 400, "malformed", ""},
          {"WhoseRecipeSaysMore", changed(drawn, "{\"request\"", "{\"a\":1,\"request\""), 400,
           "malformed", ""},
          {"WhoseSizeIsNone", changed(drawn, "\"width\":24", "\"width\":0"), 422, "out-of-range",
           "/width"},
          {"WhoseParameterIsUnknown", changed(drawn, "\"width\"", "\"wide\""), 422, "unknown-name",
           "/wide"},
          {"WhoseSceneIsWrong", changed(drawn, "\"objects\":[{", "\"objects\":[{\"radus\":1,"), 422,
           "unknown-name", "/scene/objects/0/radus"},
          {"WhichAsksForTooMuch", changed(drawn, "\"width\":24", "\"width\":16777216"), 422,
           "limit", "/width"}};
}
INSTANTIATE_TEST_SUITE_P(Is, BrokenPicture, testing::ValuesIn(broken_pictures()), law_of);

TEST(Verify, TakesNothingButAPng) {
  for (const char* body : {"", "{}", "\xFF\xD8\xFF", "GIF89a"}) {
    const Response response = host().post("/verify", body, "image/png");
    EXPECT_EQ(response.status, 415) << body;
    EXPECT_EQ(problem_of(response).type, "/problems/media-type");
  }
  EXPECT_EQ(problem_of(host().post("/verify?key=a", picture(), "image/png")).type,
            "/problems/conflict");
  EXPECT_EQ(host().get("/verify").status, 405);
  EXPECT_EQ(problem_of(host().post("/render?key=a", picture(), "image/png")).type,
            "/problems/conflict");
}

// A text that unpacks to more than a body may hold costs a body's bytes (RecipeMemory), and no
// more.
TEST(Recipe, ThatUnpacksToMoreThanABodyIsRefused) {
  const std::string drawn = picture(), text = recipe_text(drawn);
  const auto padded = [&](std::size_t size) {
    return with_recipe(drawn, text + std::string(size - text.size(), ' '));
  };
  const std::size_t most = 4 << 20;  // which is a few KB of the file
  for (const char* path : {"/render", "/verify"}) {
    EXPECT_EQ(host().post(path, padded(most), "image/png").status, 200);
    const ProblemError refused = only_error(host().post(path, padded(most + 1), "image/png"));
    EXPECT_THAT(refused.allowed, testing::HasSubstr("TIA_MAX_BODY_BYTES"));
  }
}

// /verify tells the request again, in canonical form.
TEST(Recipe, ThatIsLongerInCanonicalFormThanABodyIsRefused) {
  std::string numbers = "[1e20";
  for (int i = 0; i < 250'000; ++i) numbers += ",1e20";
  const std::string text = R"({"version":"0","request":{"scene":)" + numbers + "]}}";
  EXPECT_EQ(problem_of(verified(with_recipe(picture(), text))).type, "/problems/limit");
}

TEST(Recipe, IsReadNoFurtherOnceNobodyWaits) {
  std::string text = "[0";
  for (int i = 0; i < 9'999; ++i) text += ",0";
  const std::string bomb = with_recipe(picture(), text + "]");
  std::stop_source source;
  source.request_stop();
  EXPECT_THROW(read_recipe(recipe_text_in(bomb, {}), {}, source.get_token()), Stopped);
}

// ---- how long a body may be -----------------------------------------------------------------

// Its type lets it in; it is no picture.
TEST(PngBody, ThatIsATextMayBeNoLongerThanATextMay) {
  Host host(read_config({{"max_body_bytes", "65536", ""}}));
  const std::string text = "{\"width\":8,\"height\":6" + std::string(65'536, ' ') + "}";
  for (const char* target : {"/render", "/explain", "/scenes"}) {
    const Response refused = host.post(target, text, "image/png");
    EXPECT_EQ(refused.status, 413) << target;
    EXPECT_EQ(problem_of(refused).type, "/problems/too-large");
  }
}

TEST(PngBody, MayBeLongerThanOthersAndNoLongerThanItsOwnLimit) {
  const BodyLimits limits(1000, 64 << 20);
  const auto fault = [&](const std::string& type, std::size_t length) -> std::string {
    RequestReader reader(limits);
    reader.feed("POST /verify HTTP/1.1\r\nHost: x\r\nContent-Type: " + type +
                "\r\nContent-Length: " + std::to_string(length) + "\r\n\r\n");
    try {
      reader.read();
    } catch (const HttpError& error) {
      EXPECT_EQ(error.type(), "too-large");
      return error.detail();
    }
    return "";
  };
  EXPECT_EQ(fault("image/png", 64 << 20), "");
  EXPECT_THAT(fault("image/png", (64 << 20) + 1), testing::HasSubstr("TIA_MAX_PNG_BYTES"));
  EXPECT_EQ(fault("application/json", 1000), "");
  EXPECT_THAT(fault("application/json", 1001), testing::HasSubstr("TIA_MAX_BODY_BYTES"));
  EXPECT_EQ(fault("Image/PNG", 1001), "");
  EXPECT_THAT(fault("image/jpeg", 1001), testing::HasSubstr("TIA_MAX_BODY_BYTES"));
}

// Keys change no byte of a picture; to write a megabyte of them takes longer than to draw it.
TEST(Recipe, LongKeysAreLeftOut) {
  const auto recipe_with_keys_of = [](std::size_t bytes) {
    const std::string scene = R"({"keys":{"k":{"title":")" + std::string(bytes, 'x') + R"("}}})";
    const Response drawn = host().post("/render", R"({"width":8,"height":6,"scene":)" + scene + "}",
                                       "application/json");
    EXPECT_EQ(drawn.status, 200) << drawn.body;
    EXPECT_EQ(host().post("/render", drawn.body, "image/png").body.substr(0, 8),
              drawn.body.substr(0, 8));
    return recipe_text(drawn.body);
  };
  EXPECT_THAT(recipe_with_keys_of(1000), testing::HasSubstr(R"("keys":{"k")"));
  EXPECT_THAT(recipe_with_keys_of(server::most_told_bytes),
              testing::Not(testing::HasSubstr("keys")));
}

}  // namespace
}  // namespace tia::test
