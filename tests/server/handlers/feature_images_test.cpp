// Feature images over HTTP: PFM holds the numbers, PNG shows them by the rule of each.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "tests/core/film/tiff_reader.h"
#include "tests/server/picture_support.h"
#include "tests/server/support.h"

namespace tia::test {
namespace {

const std::string three_shapes = R"({"objects":[
    {"type":"sphere","center":[-1,0,-9],"radius":1.5,"material":{"color":[1,0.4,0.1]}},
    {"type":"box","min":[0.5,-1,-10],"max":[2.5,1,-7],"material":{"color":0.3}},
    {"type":"plane","point":[0,-2,0],"normal":[0,1,0],"material":{"color":[0.1,0.6,0.2]}}],
    "lights":[{"type":"point","position":[4,6,-3]},{"type":"point","position":[-4,6,-3]}]})";

std::string feature_image(const std::string& integrator, const std::string& more) {
  const Response response =
      host().post("/render", R"({"width":61,"height":43,"integrator":")" + integrator + "\"" +
                                 more + R"(,"scene":)" + three_shapes + "}");
  EXPECT_EQ(response.status, 200) << response.body;
  return response.body;
}
Pixels<float> feature_numbers(const std::string& integrator, const std::string& more = "") {
  return decode_pfm(feature_image(integrator, R"(,"format":"pfm")" + more));
}
Pixels<unsigned char> feature_codes(const std::string& integrator, const std::string& more = "") {
  return decode_png(feature_image(integrator, more));
}

// That each code is the one nearest to 255 x what `show` makes of its pixel's number.
template <class Show>
void expect_shown(const std::string& integrator, const std::string& more, Show show) {
  SCOPED_TRACE(integrator + more);
  const auto image = feature_numbers(integrator, more);
  const auto shown = feature_codes(integrator, more);
  std::set<int> seen;
  ASSERT_EQ(image.rgb.size(), shown.rgb.size());
  for (std::size_t i = 0; i < image.rgb.size(); ++i) {
    const double expected = show(image, i);
    ASSERT_NEAR(shown.rgb[i], 255 * std::min(1.0, std::max(0.0, expected)), 0.5 + 1e-4) << i;
    seen.insert(shown.rgb[i]);
  }
  EXPECT_GT(seen.size(), 2U);
}

TEST(FeatureImages, NormalsAreShownAroundGrey) {
  for (const char* more : {"", R"(,"samples":4)"})
    expect_shown("normal", more, [](const Pixels<float>& image, std::size_t i) {
      const float* pixel = &image.rgb[i - i % 3];
      if (pixel[0] == 0 && pixel[1] == 0 && pixel[2] == 0) return 0.0;
      return 0.5 + 0.5 * static_cast<double>(image.rgb[i]);
    });
}

TEST(FeatureImages, DistancesAreShownAsTheirInverse) {
  expect_shown("depth", "", [](const Pixels<float>& image, std::size_t i) {
    return 1 / (1 + static_cast<double>(image.rgb[i]));
  });
}

TEST(FeatureImages, SharesOfLightsAreShownAsTheyAre) {
  for (const char* more : {"", R"(,"samples":4)"})
    expect_shown("shadow", more, [](const Pixels<float>& image, std::size_t i) {
      return static_cast<double>(image.rgb[i]);
    });
}

TEST(FeatureImages, CostsAreShownByTheirLogarithm) {
  expect_shown("cost", R"(,"samples":16)", [](const Pixels<float>& image, std::size_t i) {
    return std::log2(1 + static_cast<double>(image.rgb[i])) / 16;
  });
}

// Of one number a pixel where a ray finds one, else of three.
TEST(FeatureImages, TiffHoldsTheNumbersOfPfm) {
  const std::set<std::string> ones{"depth", "planar_depth", "object", "shadow", "cost"};
  for (const char* integrator : {"depth", "planar_depth", "object", "shadow", "cost", "normal",
                                 "albedo", "label", "whitted"}) {
    const auto numbers = feature_numbers(integrator);
    const std::string file = feature_image(integrator, R"(,"format":"tiff")");
    const TiffPicture tiff = read_tiff(file);
    ASSERT_EQ(tiff.width * tiff.height * 3, numbers.rgb.size());
    const bool is_one = ones.contains(integrator);
    ASSERT_EQ(tiff.channels, is_one ? 1U : 3U) << integrator;
    for (std::size_t i = 0; i < numbers.rgb.size(); ++i)
      ASSERT_EQ(tiff.numbers[i / 3 * tiff.channels + i % 3 % tiff.channels], numbers.rgb[i]);
  }
}

TEST(FeatureImages, DepthsOutsideOfTheirRangeAreNoneOrInfinite) {
  const auto all = feature_numbers("planar_depth");
  const auto cut = feature_numbers("planar_depth", R"(,"depth_range":[8,9])");
  std::set<int> met;
  for (std::size_t i = 0; i < all.rgb.size(); ++i) {
    const float depth = all.rgb[i];
    const float expected = depth < 8 ? 0 : depth > 9 ? INFINITY : depth;
    ASSERT_EQ(cut.rgb[i], expected);
    met.insert(depth < 8 ? 0 : depth > 9 ? 2 : 1);
  }
  EXPECT_EQ(met.size(), 3U);
  for (const char* query :
       {"integrator=planar_depth&depth_range=1,2", "integrator=normal&format=pfm&depth_range=1,2",
        "integrator=depth&format=pfm&depth_range=2,1"})
    EXPECT_EQ(only_error(host().get(std::string("/render?") + query)).pointer, "/depth_range");
}

TEST(FeatureImages, DataIsStoredLinearlyWhateverTheCurve) {
  for (const char* integrator : {"normal", "depth", "object", "shadow", "cost"}) {
    SCOPED_TRACE(integrator);
    const auto plain = feature_codes(integrator);
    EXPECT_TRUE(feature_codes(integrator, R"(,"transfer":"srgb")") == plain);
    EXPECT_TRUE(feature_codes(integrator, R"(,"transfer":"linear")") == plain);
    EXPECT_TRUE(feature_codes(integrator, R"(,"transfer":"aces","exposure":1)") == plain);
  }
}

TEST(FeatureImages, AlbedoIsEncodedAndNotExposed) {
  expect_shown("albedo", R"(,"transfer":"linear")", [](const Pixels<float>& image, std::size_t i) {
    return static_cast<double>(image.rgb[i]);
  });
  expect_shown("albedo", R"(,"transfer":"srgb")", [](const Pixels<float>& image, std::size_t i) {
    const double v = static_cast<double>(image.rgb[i]);
    return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
  });
  for (const char* tone :
       {R"(,"exposure":1)", R"(,"white_balance_kelvin":3000)", R"(,"transfer":"agx")"})
    EXPECT_TRUE(feature_codes("albedo", tone) == feature_codes("albedo")) << tone;
}

TEST(FeatureImages, EachObjectHasAColourOfItsOwnAndNothingIsBlack) {
  const auto image = feature_numbers("object");
  const auto shown = feature_codes("object");
  std::map<float, std::set<std::vector<int>>> colors;
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
    EXPECT_EQ(image.rgb[i], image.rgb[i + 2]);
    colors[image.rgb[i]].insert({shown.rgb[i], shown.rgb[i + 1], shown.rgb[i + 2]});
  }
  ASSERT_EQ(colors.size(), 4U);  // three objects and the sky
  std::set<std::vector<int>> all;
  for (const auto& [number, its] : colors) {
    EXPECT_EQ(its.size(), 1U);
    all.insert(*its.begin());
  }
  EXPECT_EQ(all.size(), 4U);
  EXPECT_EQ(*colors.at(0).begin(), (std::vector<int>{0, 0, 0}));
}

TEST(FeatureImages, NumbersOfObjectsAreNeverAveraged) {
  EXPECT_TRUE(feature_numbers("object", R"(,"samples":16)") == feature_numbers("object"));
  EXPECT_TRUE(feature_codes("object", R"(,"samples":16,"threshold":0.01)") ==
              feature_codes("object"));
}

// What a scene says of rays is meant for its own integrator: four that agree by chance would settle
// a pixel of ambient occlusion. What the request says holds.
TEST(AmbientOcclusionOverHttp, HasRaysOfItsOwnWhereTheSceneSpeaksOfAnotherIntegrators) {
  constexpr int pixels = 16 * 12;
  const auto primary = [](const std::string& more) {
    const Response response =
        host().get("/render?scene=whitted&integrator=ambient_occlusion&width=16&height=12" + more);
    const std::string text = header(response, "Tia-Rays").value_or("primary=0");
    return std::stoi(text.substr(text.find("primary=") + 8));
  };
  EXPECT_EQ(primary(""), 32 * pixels);
  EXPECT_EQ(primary("&samples=3"), 3 * pixels);
  EXPECT_GE(primary("&threshold=0.2"), 32 * pixels);
}

}  // namespace
}  // namespace tia::test
