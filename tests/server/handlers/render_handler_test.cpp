// /render: the same request gives the same bytes, however it is asked.
#include <algorithm>

#include "tests/core/film/png_chunks.h"
#include "tests/core/film/radiance_reader.h"
#include "tests/server/picture_support.h"
#include "tests/server/support.h"

namespace tia::test {
namespace {

std::string thesis_text() {
  return file_bytes(std::string(TIA_SOURCE_DIR) + "/web/scenes/thesis.json");
}

Response post_render(const Value& parameters) {
  return host().post("/render", to_json(parameters));
}
Response get_render(const Value& parameters) {
  return host().get(std::string("/render?") + query_of(parameters));
}

// The parameters, small: 37 x 23, which no tile or lane divides.
Value small_picture_of(Value::Object more = {}) {
  more.emplace_back("width", 37);
  more.emplace_back("height", 23);
  return more;
}

// Every way of placing the light, with every scene, format and curve, and others in turn.
std::vector<Value> combinations() {
  const std::vector<Value::Object> lights{
      {}, {{"key", "a"}}, {{"key", "w"}}, {{"light", Value::Array{-1.5, 20, 1e1}}}};
  const Value whole = parse_json(thesis_text());
  const std::vector<Value::Object> others{{},
                                          {{"threads", 1}},
                                          {{"seed", 9007199254740991.0}},
                                          {{"integrator", "thesis"}},
                                          {{"crop", Value::Array{3, 2, 20, 23}}}};
  std::vector<Value> list;
  for (const auto& light : lights)
    for (const Value& scene : {Value(), Value("thesis"), whole})
      for (const char* format : {"png", "pfm", "hdr"})
        for (const char* transfer : {"", "srgb", "linear"}) {
          Value::Object all = light;
          if (scene != Value()) all.emplace_back("scene", scene);
          all.emplace_back("format", format);
          if (*transfer != '\0') all.emplace_back("transfer", transfer);
          const auto& other = others[list.size() % others.size()];
          all.insert(all.end(), other.begin(), other.end());
          list.push_back(small_picture_of(all));
        }
  return list;
}

TEST(RenderHandler, GetAndPostOfTheSameRequestGiveTheSameBytes) {
  for (const Value& parameters : combinations()) {
    SCOPED_TRACE(query_of(parameters));
    const Response by_get = get_render(parameters), by_post = post_render(parameters);
    ASSERT_EQ(by_get.status, 200) << by_get.body;
    ASSERT_EQ(by_post.status, 200) << by_post.body;
    EXPECT_EQ(by_get.content_type, by_post.content_type);
    EXPECT_EQ(header(by_get, "Tia-Rays"), header(by_post, "Tia-Rays"));
    EXPECT_TRUE(by_get.body == by_post.body);
  }
}

TEST(RenderHandler, NoParameterIsRequired) {
  const Response response = host().get("/render");
  EXPECT_EQ(response.status, 200);
  EXPECT_EQ(response.content_type, "image/png");
  const auto image = decode_png(response.body);
  EXPECT_EQ(image.width, 640);
  EXPECT_EQ(image.height, 480);
  EXPECT_TRUE(host().post("/render", "{}").body == response.body);
  EXPECT_TRUE(host().get("/render?&&").body == response.body);
}

TEST(RenderHandler, ThreadsNeverChangeTheBytes) {
  for (const char* format : {"width=131&height=97&format=png", "width=131&height=97&format=pfm",
                             "width=131&height=97&format=hdr", "width=701&height=603&format=png"}) {
    const std::string query = std::string("/render?key=a&") + format + "&threads=";
    const std::string one = host().get(query + "1").body;
    for (const char* threads : {"2", "7", "64"})
      EXPECT_TRUE(host().get(query + threads).body == one) << format << threads;
  }
}

TEST(RenderHandler, ALargePngIsMadeInStripsAndHoldsWhatSmallOnesHold) {
  const std::string full = "/render?key=a&width=701&height=603";
  const std::string body = host().get(full).body;
  const auto parts = std::ranges::count(chunks_of(body), "IDAT", &Chunk::type);
  EXPECT_EQ(parts, 1 + 5 + 1) << "a header, strips of 256 KiB, a checksum";
  const auto png = decode_png(body);
  EXPECT_TRUE(decode_png(host().get(full + "&crop=0,0,350,603").body) ==
              png.window(0, 0, 350, 603));
  EXPECT_TRUE(decode_png(host().get(full + "&crop=350,0,701,603").body) ==
              png.window(350, 0, 701, 603));
}

TEST(RenderHandler, ACropIsTheWindowOfTheFullPicture) {
  const std::string full = "/render?key=a&width=75&height=50";
  const auto png = decode_png(host().get(full).body);
  const auto pfm = decode_pfm(host().get(full + "&format=pfm").body);
  const int windows[][4] = {{0, 0, 75, 50},  {0, 0, 1, 1},    {74, 49, 75, 50},
                            {10, 7, 43, 42}, {31, 0, 34, 50}, {0, 33, 75, 34}};
  for (const auto& [x0, y0, x1, y1] : windows) {
    const std::string crop = "&crop=" + std::to_string(x0) + "," + std::to_string(y0) + "," +
                             std::to_string(x1) + "," + std::to_string(y1);
    SCOPED_TRACE(crop);
    EXPECT_TRUE(decode_png(host().get(full + crop).body) == png.window(x0, y0, x1, y1));
    EXPECT_TRUE(decode_pfm(host().get(full + crop + "&format=pfm").body) ==
                pfm.window(x0, y0, x1, y1));
  }
}

TEST(RenderHandler, ThePngHoldsThePfmThroughTheTransferCurve) {
  const std::string lit = "/render?key=a&width=64&height=48";
  const auto light = decode_pfm(host().get(lit + "&format=pfm").body);
  const auto linear = decode_png(host().get(lit + "&transfer=linear").body);
  const auto srgb = decode_png(host().get(lit + "&transfer=srgb").body);
  ASSERT_EQ(linear.rgb.size(), light.rgb.size());
  ASSERT_EQ(srgb.rgb.size(), light.rgb.size());
  for (std::size_t i = 0; i < light.rgb.size(); ++i) {
    const double v = std::min(1.0, std::max(0.0, static_cast<double>(light.rgb[i])));
    const double curve = v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
    ASSERT_NEAR(linear.rgb[i], 255 * v, 0.5 + 1e-9);
    ASSERT_NEAR(srgb.rgb[i], 255 * curve, 0.5 + 1e-4);
  }
}

TEST(RenderHandler, TheThesisSceneStoresLinearValues) {
  const std::string picture = "/render?key=a&width=37&height=23";
  EXPECT_TRUE(host().get(picture).body == host().get(picture + "&transfer=linear").body);
  EXPECT_FALSE(host().get(picture).body == host().get(picture + "&transfer=srgb").body);
}

TEST(RenderHandler, LinearFilesAreBeforeAnyTone) {
  for (const char* format : {"pfm", "hdr"}) {
    const std::string picture = std::string("/render?key=a&width=37&height=23&format=") + format;
    const Response response = host().get(picture);
    EXPECT_EQ(response.content_type,
              *format == 'p' ? "image/x-portable-floatmap" : "image/vnd.radiance");
    for (const char* tone :
         {"&transfer=srgb", "&transfer=agx", "&exposure=2", "&white_balance_kelvin=3000"}) {
      const Response toned = host().get(picture + tone);
      EXPECT_TRUE(toned.body == response.body) << tone;
      EXPECT_EQ(header(toned, "ETag"), header(response, "ETag")) << tone;
    }
  }
}

// A stop is twice the light, whether the lamp or the film gives it.
TEST(RenderHandler, ExposureIsAsManyTimesTheLight) {
  const auto with = [](const std::string& light, const std::string& more) {
    return decode_png(host()
                          .post("/render", R"({"width":40,"height":30,"scene":{"ambient_light":0,
        "objects":[{"type":"sphere","center":[0,0,-9],"radius":2}],
        "lights":[{"type":"point","position":[3,4,-2],"intensity":)" +
                                               light + "}]}" + more + "}")
                          .body);
  };
  for (const char* transfer : {"srgb", "linear", "aces", "agx"}) {
    const std::string curve = std::string(R"(,"transfer":")") + transfer + '"';
    EXPECT_TRUE(with("0.125", curve + R"(,"exposure":2)") == with("0.5", curve)) << transfer;
    EXPECT_TRUE(with("2", curve + R"(,"exposure":-1)") == with("1", curve)) << transfer;
    EXPECT_FALSE(with("1", curve + R"(,"exposure":-1)") == with("1", curve)) << transfer;
  }
}

// To 1/256 of each pixel's largest component, as tests/core/film/hdr_test.cpp derives.
TEST(RenderHandler, HdrHoldsThePfmBeforeAnyTransferCurve) {
  const std::string picture = "/render?scene=whitted&width=37&height=23&format=";
  const Response response = host().get(picture + "hdr");
  EXPECT_EQ(response.content_type, "image/vnd.radiance");
  EXPECT_TRUE(host().get(picture + "hdr&transfer=linear").body == response.body);
  const RadiancePicture hdr = read_radiance(response.body);
  const auto pfm = decode_pfm(host().get(picture + "pfm").body);
  ASSERT_EQ(hdr.width, pfm.width);
  ASSERT_EQ(hdr.height, pfm.height);
  for (std::size_t i = 0; i < hdr.pixels.size(); ++i) {
    const float* const light = &pfm.rgb[3 * i];
    for (std::size_t c = 0; c < 3; ++c)
      ASSERT_NEAR(component_of(hdr.pixels[i], c), light[c],
                  std::max({light[0], light[1], light[2]}) / 256);
  }
}

// What no ray meets is infinitely far: the largest number that RGBE has.
TEST(RenderHandler, HdrOfAnInfiniteDepthIsFinite) {
  const std::string picture = "/render?scene=%7B%7D&integrator=depth&width=4&height=3&format=";
  EXPECT_EQ(decode_pfm(host().get(picture + "pfm").body).rgb[0],
            std::numeric_limits<float>::infinity());
  const RadiancePicture read = read_radiance(host().get(picture + "hdr").body);
  for (const Rgbe& pixel : read.pixels) EXPECT_EQ(pixel, (Rgbe{255, 255, 255, 255}));
}

TEST(RenderHandler, AKeyIsTheLightAtItsPlace) {
  const Value keys = at(parse_json(thesis_text()), "keys");
  for (const auto& [key, binding] : *keys.as<Value::Object>()) {
    SCOPED_TRACE(key);
    const Response pressed = get_render(small_picture_of({{"key", key}}));
    const Response placed = get_render(small_picture_of({{"light", at(binding, "light")}}));
    EXPECT_EQ(pressed.status, 200);
    EXPECT_TRUE(pressed.body == placed.body);
    EXPECT_FALSE(pressed.body == get_render(small_picture_of()).body);
  }
}

TEST(RenderHandler, ALightIsReadWithAndWithoutBrackets) {
  const std::string picture = "/render?width=37&height=23&light=";
  const std::string body = host().get(picture + "-20,20,-10").body;
  for (const char* light : {"[-20,20,-10]", "%5B-20,20,-10%5D", "-20%2C20%2C-10", "-2e1,20.0,-10"})
    EXPECT_TRUE(host().get(picture + light).body == body) << light;
}

TEST(RenderHandler, ASceneInTheRequestIsTheSceneOfThatName) {
  const Value whole = parse_json(thesis_text());
  for (const char* key : {"a", "d", "s", "w"}) {
    const std::string named =
        get_render(small_picture_of({{"scene", "thesis"}, {"key", key}})).body;
    EXPECT_TRUE(get_render(small_picture_of({{"scene", whole}, {"key", key}})).body == named);
    EXPECT_TRUE(post_render(small_picture_of({{"scene", whole}, {"key", key}})).body == named);
  }
}

TEST(RenderHandler, DefaultKeysApplyToASceneThatNamesNone) {
  const Value scene = parse_json(R"({"objects":[{"type":"sphere","center":[0,0,-5],"radius":1}]})");
  std::vector<std::string> pictures{get_render(small_picture_of({{"scene", scene}})).body};
  for (const char* key : {"a", "d", "s", "w"})
    pictures.push_back(get_render(small_picture_of({{"scene", scene}, {"key", key}})).body);
  std::sort(pictures.begin(), pictures.end());
  EXPECT_EQ(std::unique(pictures.begin(), pictures.end()), pictures.end());
}

TEST(RenderHandler, APatchKeyChangesTheSceneByMergePatch) {
  const Value scene = parse_json(
      R"({"background":0.25,"keys":{"n":{"background":0.75,"options":{"transfer":"linear"}}}})");
  const auto before = decode_png(get_render(small_picture_of({{"scene", scene}})).body);
  const auto after =
      decode_png(get_render(small_picture_of({{"scene", scene}, {"key", "n"}})).body);
  EXPECT_EQ(before.at(5, 5, 0), 137);  // sRGB of 0.25
  EXPECT_EQ(after.at(5, 5, 0), 191);   // 0.75 * 255, linear
}

TEST(RenderHandler, APatchThatLeavesNoSceneIsAFaultOfTheKey) {
  const Value scene = parse_json(R"({"keys":{"n":{"background":-1}}})");
  const Response response = get_render(small_picture_of({{"scene", scene}, {"key", "n"}}));
  EXPECT_EQ(response.status, 422);
  const std::string pointer = only_error(response).pointer;  // into the request
  EXPECT_TRUE(pointer.starts_with("/key") || pointer.starts_with("/scene/keys/n/")) << pointer;
}

}  // namespace
}  // namespace tia::test
