// Layers over HTTP: OpenEXR files read by a reader of the tests' own, held to the pictures that
// show the same, and to closed forms.
#include <cmath>

#include "server/stores/digest.h"
#include "tests/core/film/exr_reader.h"
#include "tests/server/picture_support.h"
#include "tests/server/support.h"

namespace tia::test {
namespace {

// A matt corner, a ball like a mirror, a lamp that shines on them, and a little light of the sky.
// `more` are members of the request.
std::string corner(const std::string& more, const std::string& options = "") {
  return R"({"width":29,"height":18,"integrator":"path")" + more + R"(,"scene":{
    "background":[0.01,0.02,0.03],"options":{)" +
         options + R"(},
    "objects":[{"type":"sphere","center":[-1,0,-7],"radius":1,
                "material":{"color":1,"diffuse":0,"reflection":0.9,"specular":0}},
               {"type":"sphere","center":[1.4,-0.4,-7],"radius":0.8,
                "material":{"color":[1,0.4,0.1]}},
               {"type":"plane","point":[0,-1.2,0],"normal":[0,1,0],
                "material":{"color":[0.5,0.8,0.3]}},
               {"type":"plane","point":[0,0,-9],"normal":[0,0,1]}],
    "lights":[{"type":"sphere","position":[0,3,-5],"radius":0.5,"color":8}]}})";
}

std::string layers_body_of(const std::string& request) {
  const Response response = host().post("/render", request);
  EXPECT_EQ(response.status, 200) << response.body;
  return response.body;
}
ExrFile exr_of(const std::string& more, const std::string& options = "") {
  return read_exr(layers_body_of(corner(R"(,"format":"exr")" + more, options)));
}
Pixels<float> pfm_of(const std::string& more) {
  return decode_pfm(layers_body_of(corner(R"(,"format":"pfm")" + more)));
}

void expect_channels(const ExrFile& file, std::initializer_list<const char*> names,
                     const Pixels<float>& expected, double off = 0) {
  std::size_t channel = 0;
  for (const char* name : names) {
    const std::vector<double>& got = file.numbers.at(name);
    ASSERT_EQ(got.size(), expected.rgb.size() / 3);
    for (std::size_t i = 0; i < got.size(); ++i) {
      const auto number = static_cast<double>(expected.rgb[3 * i + channel]);
      if (off == 0) ASSERT_EQ(got[i], number) << name << i;
      else ASSERT_NEAR(got[i], number, off * std::fabs(number) + 1e-7) << name << i;
    }
    ++channel;
  }
}

TEST(Layers, ColourIsThatOfLinearFilesInHalvesOrFloats) {
  const Pixels<float> expected = pfm_of(R"(,"samples":4)");
  const ExrFile full = exr_of(R"(,"samples":4,"depth":32)");
  EXPECT_EQ(full.types, (std::map<std::string, int>{{"A", 2}, {"B", 2}, {"G", 2}, {"R", 2}}));
  expect_channels(full, {"R", "G", "B"}, expected);
  for (const double alpha : full.numbers.at("A")) ASSERT_EQ(alpha, 1);
  const ExrFile half = exr_of(R"(,"samples":4)");
  EXPECT_EQ(half.types, (std::map<std::string, int>{{"A", 1}, {"B", 1}, {"G", 1}, {"R", 1}}));
  expect_channels(half, {"R", "G", "B"}, expected, 0x1p-11);
}

TEST(Layers, AFileTellsItsWindowVersionAndRecipe) {
  const Response response =
      host().get("/render?width=40&height=30&crop=3,2,20,21&format=exr&scene=shapes");
  ASSERT_EQ(response.status, 200);
  EXPECT_EQ(response.content_type, "image/x-exr");
  const ExrFile file = read_exr(response.body);
  EXPECT_EQ(file.data, (ExrFile::Box{3, 2, 19, 20}));
  EXPECT_EQ(file.display, (ExrFile::Box{0, 0, 39, 29}));
  EXPECT_EQ(file.attributes.at("tia:version"), full_version());
  EXPECT_EQ(header(response, "ETag"), '"' + sha256_hex(file.attributes.at("tia:recipe")) + '"');
  expect_channels(file, {"R", "G", "B"},
                  decode_pfm(host()
                                 .get("/render?width=40&height=30&crop=3,2,20,21&format=pfm&"
                                      "scene=shapes")
                                 .body),
                  0x1p-11);
}

TEST(Layers, FeaturesAreTheFeatureImages) {
  for (const char* samples :
       {R"(,"samples":1)", R"(,"samples":5)", R"(,"samples":4,"threshold":0.1)"})
    for (const char* integrator : {"path", "whitted"}) {
      SCOPED_TRACE(std::string(integrator) + samples);
      const std::string by = std::string(samples) + R"(,"integrator":")";
      const auto feature = [&](const std::string& name) {
        std::string request = corner(samples + std::string(R"(,"format":"pfm")"));
        return decode_pfm(
            layers_body_of(request.replace(request.find("\"path\""), 6, '"' + name + '"')));
      };
      std::string request = corner(
          samples + std::string(R"(,"format":"exr","aov":["object","Z","normal","albedo"])"));
      request.replace(request.find("\"path\""), 6, std::string("\"") + integrator + '"');
      const ExrFile file = read_exr(layers_body_of(request));
      EXPECT_EQ(file.types.size(), 8U);
      EXPECT_EQ(file.types.at("object"), 0);
      EXPECT_EQ(file.types.at("Z"), 2);
      expect_channels(file, {"normal.X", "normal.Y", "normal.Z"}, feature("normal"));
      expect_channels(file, {"albedo.R", "albedo.G", "albedo.B"}, feature("albedo"));
      expect_channels(file, {"Z"}, feature("depth"));
      expect_channels(file, {"object"}, feature("object"));
    }
}

TEST(Layers, PartsAreNeverNegativeAndAddUpAlsoWhereSamplesAreClamped) {
  const std::string parts =
      R"(,"samples":16,"depth":32,"aov":["rgba","direct","indirect","emission"])";
  for (const char* clamp : {"", R"("clamp":0.5)"}) {
    const ExrFile file = exr_of(parts, clamp);
    const auto at = [&](const std::string& name, std::size_t i) {
      return file.numbers.at(name)[i];
    };
    double sum_of_direct = 0, sum_of_indirect = 0, sum_of_emission = 0;
    for (const std::string channel : {"R", "G", "B"})
      for (std::size_t i = 0; i < 29 * 18; ++i) {
        const double direct = at("direct." + channel, i), indirect = at("indirect." + channel, i),
                     emission = at("emission." + channel, i);
        ASSERT_NEAR(direct + indirect + emission, at(channel, i),
                    1e-6 * std::max(1.0, at(channel, i)));
        ASSERT_GE(std::min({direct, indirect, emission}), 0);
        sum_of_direct += direct, sum_of_indirect += indirect, sum_of_emission += emission;
      }
    for (const double sum : {sum_of_direct, sum_of_indirect, sum_of_emission}) EXPECT_GT(sum, 1);
  }
}

// Where all surfaces scatter, max_depth 0 leaves what is seen to shine, and 1 what comes straight
// from a light to what is seen, too.
TEST(Layers, PartsOfMattSurfacesAreThoseOfFewerBounces) {
  const std::string scene = R"(,"scene":{"background":[0.1,0.2,0.3],"objects":[
      {"type":"sphere","center":[0,0,-7],"radius":1.5,"material":{"color":0.8}},
      {"type":"sphere","center":[2,1,-6],"radius":0.7,"material":{"emission":[2,1,0]}},
      {"type":"plane","point":[0,-1.2,0],"normal":[0,1,0]}]}})";
  const std::string asked = R"({"integrator":"path","samples":8,"width":24,"height":16)";
  const auto up_to = [&](int depth) {
    return decode_pfm(
        layers_body_of(asked + R"(,"format":"pfm","max_depth":)" + std::to_string(depth) + scene));
  };
  const ExrFile file = read_exr(
      layers_body_of(asked + R"(,"format":"exr","aov":["direct","indirect","emission"])" + scene));
  expect_channels(file, {"emission.R", "emission.G", "emission.B"}, up_to(0), 1e-6);
  const Pixels<float> once = up_to(1), none = up_to(0), all = up_to(16);
  Pixels<float> direct = once, indirect = all;
  for (std::size_t i = 0; i < once.rgb.size(); ++i) {
    direct.rgb[i] -= none.rgb[i];
    indirect.rgb[i] -= once.rgb[i];
  }
  for (std::size_t i = 0; i < once.rgb.size() / 3; ++i) {
    ASSERT_NEAR(file.numbers.at("direct.G")[i], static_cast<double>(direct.rgb[3 * i + 1]), 1e-6);
    ASSERT_NEAR(file.numbers.at("indirect.G")[i], static_cast<double>(indirect.rgb[3 * i + 1]),
                1e-6);
  }
}

// Each sample of the thesis' unlit scene is 0 or 0.8, k of n the latter: the mean is m = 0.8 k/n,
// and the unbiased variance of the mean (0.8^2 k - n m^2) / (n - 1) / n = m (0.8 - m) / (n - 1).
TEST(Layers, VarianceAndSamplesAreThoseOfThePixel) {
  const ExrFile file = read_exr(
      host()
          .get("/render?samples=9&width=32&height=24&format=exr&depth=32&aov=rgba,samples,variance")
          .body);
  int mixed = 0;
  for (std::size_t i = 0; i < 32 * 24; ++i) {
    const double mean = file.numbers.at("R")[i];
    ASSERT_NEAR(file.numbers.at("variance.R")[i], mean * (0.8 - mean) / 8, 1e-7);
    ASSERT_EQ(file.numbers.at("samples")[i], 9);
    mixed += mean > 0.01 && mean < 0.79 ? 1 : 0;
  }
  EXPECT_GT(mixed, 10);
  const ExrFile single =
      read_exr(host().get("/render?width=8&height=8&format=exr&aov=samples").body);
  EXPECT_EQ(single.numbers.at("samples"), std::vector<double>(64, 1));
}

// What a budget leaves has the address of a picture without one: of the same bytes, in all layers.
TEST(Layers, ABudgetsContentLocationGivesTheSameBytes) {
  Config config;
  config.cache_bytes = 0;
  Host other(config);
  const std::string asked =
      "/render?scene=shapes&integrator=path&width=20&height=15&samples=500&format=exr&"
      "aov=rgba,Z,normal,direct,indirect,emission,variance,samples";
  const Response response = other.get(asked + "&max_rays=60000");
  ASSERT_EQ(response.status, 200) << response.body;
  const Response again = other.get(header(response, "Content-Location").value_or(""));
  EXPECT_TRUE(again.body == response.body);
  EXPECT_EQ(header(again, "ETag"), header(response, "ETag"));
  const ExrFile file = read_exr(response.body);
  const std::string count = std::to_string(static_cast<int>(file.numbers.at("samples")[0]));
  EXPECT_EQ(header(response, "Tia-Samples"),
            "min=" + count + ", mean=" + count + ".0, max=" + count);
}

TEST(Layers, ATransparentBackdropIsInAlphaAndTheLightIsMultipliedByIt) {
  const auto asked = [](const std::string& backdrop, const std::string& format) {
    return layers_body_of(
        R"({"width":24,"height":18,"samples":4,"scene":{"backdrop":)" + backdrop +
        R"(,"objects":[{"type":"sphere","center":[0,0,-9],"radius":2}]},"format":)" + format + "}");
  };
  const ExrFile file = read_exr(asked(R"("transparent")", R"("exr","depth":32)"));
  expect_channels(file, {"R", "G", "B"}, decode_pfm(asked("0", R"("pfm")")));
  std::map<double, int> alphas;
  for (const double alpha : file.numbers.at("A")) ++alphas[alpha * 4];
  EXPECT_GT(alphas[0], 100);
  EXPECT_GT(alphas[4], 50);
  for (const auto& [quarters, count] : alphas) EXPECT_EQ(quarters, std::round(quarters));
}

}  // namespace
}  // namespace tia::test
