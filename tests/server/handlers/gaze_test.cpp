// Pictures for a gaze over HTTP: headers, names, time, what they cannot be asked with.
#include <cstdio>

#include "tests/server/picture_support.h"
#include "tests/server/requests/recipe_support.h"
#include "tests/server/support.h"

namespace tia::test {
namespace {

/// Told: what Tia-Gaze says.
struct Told {
  double slope = 0;
  long long fovea = 0, periphery = 0, full = 0;
};
Told told_of(const Response& response) {
  Told told;
  EXPECT_EQ(std::sscanf(header(response, "Tia-Gaze").value_or("").c_str(),
                        "slope=%lf, fovea=%lld, periphery=%lld, full=%lld", &told.slope,
                        &told.fovea, &told.periphery, &told.full),
            4);
  return told;
}
long long primary_told(const Response& response) {
  long long primary = 0;
  std::sscanf(header(response, "Tia-Rays").value_or("").c_str(), "primary=%lld", &primary);
  return primary;
}
const std::string seen = "/render?key=a&width=200&height=150&gaze=80,60";

TEST(GazeRequest, TellsWhatWasTraced) {
  const Response drawn = host().get(seen);
  ASSERT_EQ(drawn.status, 200) << drawn.body;
  const Told told = told_of(drawn);
  EXPECT_EQ(told.slope, 0.022);
  EXPECT_EQ(told.full, 200 * 150);
  EXPECT_EQ(told.fovea + told.periphery, primary_told(drawn));
  EXPECT_LT(primary_told(drawn), told.full);
  EXPECT_EQ(header(host().head(seen), "Tia-Gaze"), header(drawn, "Tia-Gaze"));
  EXPECT_EQ(header(host().get("/render?scene=whitted&width=20&height=15"), "Tia-Gaze"),
            std::nullopt);
}

TEST(GazeRequest, OfManySamplesAndOfAWindow) {
  const Response sampled = host().get(seen + "&samples=3&format=pfm");
  EXPECT_EQ(3 * (told_of(sampled).fovea + told_of(sampled).periphery), primary_told(sampled));
  const auto all = decode_pfm(host().get(seen + "&format=pfm").body);
  const Response part = host().get(seen + "&format=pfm&crop=70,50,110,90");
  const auto cut = decode_pfm(part.body);
  EXPECT_LT(primary_told(part), primary_told(host().get(seen)));
  for (std::size_t y = 0; y < 40; ++y)
    for (std::size_t i = 0; i < 3 * 40; ++i)
      ASSERT_EQ(cut.rgb[3 * 40 * y + i], all.rgb[3 * (200 * (y + 50) + 70) + i]);
}

TEST(GazeRequest, KeepsToItsRaysAndIsDrawnAgainFromItself) {
  const long long all = primary_told(host().get(seen));
  const Response fewer = host().get(seen + "&gaze_rays=" + std::to_string(all / 2));
  EXPECT_LE(primary_told(fewer), all / 2);
  EXPECT_GT(told_of(fewer).slope, 0.022);
  EXPECT_TRUE(host().post("/render", fewer.body, "image/png").body == fewer.body);
  // What does not bind is no other picture.
  EXPECT_EQ(header(host().get(seen + "&gaze_rays=" + std::to_string(all)), "ETag"),
            header(host().get(seen), "ETag"));
  const ProblemError refused = only_error(host().get(seen + "&gaze_rays=2"));
  EXPECT_EQ(refused.pointer, "/gaze_rays");
  long long least = 0;
  ASSERT_EQ(std::sscanf(refused.allowed.c_str(), "at least %lld", &least), 1);
  EXPECT_EQ(primary_told(host().get(seen + "&gaze_rays=" + std::to_string(least))), least);
}

TEST(GazeRequest, InATimeIsThePictureThatItsAddressNames) {
  for (const char* ms : {"1", "100000"}) {
    const Response timed = host().get(seen + "&frame_ms=" + ms);
    ASSERT_EQ(timed.status, 200) << timed.body;
    const auto address = header(timed, "Content-Location");
    ASSERT_TRUE(address);
    EXPECT_THAT(*address, testing::HasSubstr("gaze_rays="));
    EXPECT_THAT(*address, testing::Not(testing::HasSubstr("frame_ms")));
    const Response named = host().get(*address);
    EXPECT_TRUE(named.body == timed.body);
    EXPECT_EQ(header(named, "ETag"), header(timed, "ETag"));
    EXPECT_EQ(header(timed, "Cache-Control"), "no-cache");
  }
  const std::string posted =
      R"({"scene":"whitted","width":64,"height":48,"gaze":[3,4],"frame_ms":9})";
  EXPECT_EQ(header(host().post("/render", posted), "Content-Location"), std::nullopt);
}

TEST(GazeRequest, IsExplainedWhereAPixelHasARay) {
  const std::string target = "/explain?scene=whitted&width=200&height=150&gaze=80,60";
  const Response whole = host().get("/explain?scene=whitted&width=200&height=150&x=80&y=60");
  EXPECT_TRUE(host().get(target + "&x=80&y=60").body == whole.body);
  const ProblemError refused = only_error(host().get(target + "&x=190&y=140"));
  EXPECT_EQ(refused.pointer, "/gaze");
  EXPECT_THAT(refused.allowed, testing::HasSubstr("fovea"));
  EXPECT_EQ(
      only_error(host().get("/explain?gaze=1,2&ray.origin=0,0,0&ray.direction=0,0,-1")).pointer,
      "/gaze");
}

struct Refused {
  const char* law;
  const char* query;
  const char* pointer;
};
void PrintTo(const Refused& refused, std::ostream* out) { *out << refused.law; }
class RefusedGaze : public testing::TestWithParam<Refused> {};
TEST_P(RefusedGaze, IsAProblemAtItsPlace) {
  const Response response =
      host().get(std::string("/render?width=40&height=30&") + GetParam().query);
  EXPECT_EQ(response.status, 422) << response.body;
  EXPECT_EQ(only_error(response).pointer, GetParam().pointer);
}
INSTANTIATE_TEST_SUITE_P(
    Of, RefusedGaze,
    testing::Values(
        Refused{"RaysAlone", "gaze_rays=100", "/gaze_rays"},
        Refused{"TimeAlone", "frame_ms=100", "/frame_ms"},
        Refused{"AcuityAlone", "acuity.slope=0.03", "/acuity"},
        Refused{"RaysOfAThreshold", "gaze=1,2&threshold=0.1&gaze_rays=99", "/gaze_rays"},
        Refused{"TimeOfAThreshold", "gaze=1,2&threshold=0.1&frame_ms=99", "/frame_ms"},
        Refused{"NoSlope", "gaze=1,2&acuity.slope=0", "/acuity/slope"},
        Refused{"Lens", "gaze=1,2&camera=%7B%22aperture%22:1,%22focus_distance%22:5%7D", "/gaze"},
        Refused{"Parallel",
                "gaze=1,2&scene=cameras&camera=%7B%22projection%22:%22orthographic%22,"
                "%22height%22:3,%22fov_degrees%22:null%7D",
                "/gaze"},
        Refused{"Panorama", "gaze=1,2&camera=%7B%22projection%22:%22equirectangular%22%7D",
                "/gaze"},
        Refused{"ManyViews",
                "gaze=1,2&camera=%7B%22display%22:%7B%22type%22:%22omnistereo%22%7D%7D", "/gaze"},
        Refused{"Denoiser", "gaze=1,2&scene=shapes&integrator=path&samples=4&denoise=true",
                "/denoise"},
        Refused{"Budget", "gaze=1,2&scene=shapes&integrator=path&budget_ms=1000", "/budget_ms"},
        Refused{"MostRays", "gaze=1,2&scene=shapes&integrator=path&max_rays=100000", "/max_rays"},
        Refused{"Layers", "gaze=1,2&format=exr&aov=normal", "/aov"},
        Refused{"Stream", "gaze=1,2&stream=events", "/stream"}),
    law_of);

}  // namespace
}  // namespace tia::test
