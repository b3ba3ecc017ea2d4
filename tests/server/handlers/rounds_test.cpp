// Pictures of chance over HTTP: how far they have come, what a budget leaves of them, and the
// address of that.
#include <regex>

#include "tests/server/picture_support.h"
#include "tests/server/requests/recipe_support.h"

namespace tia::test {
namespace {

const std::string occlusion =
    "/render?scene=shapes&integrator=ambient_occlusion&width=40&height=30";

struct Samples {
  int least = 0, most = 0;
  double mean = 0;
};
Samples samples_of(const Response& response) {
  Samples samples;
  const std::string text = header(response, "Tia-Samples").value_or("");
  EXPECT_EQ(std::sscanf(text.c_str(), "min=%d, mean=%lf, max=%d", &samples.least, &samples.mean,
                        &samples.most),
            3)
      << text;
  return samples;
}
double noise_of(const Response& response) {
  return std::stod(header(response, "Tia-Noise").value_or("nan"));
}

TEST(Rounds, NoiseTellsHowFarItHasCome) {
  const Response plain = host().get(occlusion + "&samples=64");
  EXPECT_FALSE(header(plain, "Tia-Samples"));
  EXPECT_FALSE(header(plain, "Tia-Noise"));
  const Response response = host().get(occlusion + "&noise=0.05");
  ASSERT_EQ(response.status, 200) << response.body;
  const Samples samples = samples_of(response);
  EXPECT_EQ(samples.least, 32);
  EXPECT_GT(samples.most, 32);
  EXPECT_LE(samples.most, 4096);
  EXPECT_GT(samples.mean, 32);
  EXPECT_LT(samples.mean, samples.most);
  EXPECT_GT(noise_of(response), 0);
  EXPECT_LE(noise_of(response), 0.05);
  // A cached one tells it, too.
  const Response again = host().get(occlusion + "&noise=0.05");
  EXPECT_EQ(header(again, "Cache-Status"), "Tia; hit");
  EXPECT_EQ(header(again, "Tia-Noise"), header(response, "Tia-Noise"));
  // With as many as it took at most it is the same picture, with fewer it is not.
  const auto capped = [&](int most) {
    return decode_png(host().get(occlusion + "&noise=0.05&samples=" + std::to_string(most)).body);
  };
  EXPECT_TRUE(capped(samples.most) == decode_png(response.body));
  EXPECT_FALSE(capped(samples.most / 2) == decode_png(response.body));
}

TEST(Rounds, NoiseIsOfWhatIsShownAlsoInLinearFiles) {
  const std::string picture = occlusion + "&format=pfm&noise=0.05";
  const Response dark = host().get(picture + "&exposure=-4"), bright = host().get(picture);
  EXPECT_NE(header(dark, "ETag"), header(bright, "ETag"));
  EXPECT_LT(samples_of(dark).mean, samples_of(bright).mean);
}

TEST(Rounds, ABudgetsContentLocationGivesTheSameBytesAndTag) {
  Config config;
  config.cache_bytes = 0;
  Host other(config);
  for (const std::string more : {"&samples=5000", "&noise=0.02", "&noise=0.1&format=pfm"}) {
    if (sanitized() && more != "&noise=0.02") continue;
    for (const char* budget : {"&max%5Frays=150000", "&budget_ms=60000&max_rays=400000"}) {
      const Response response = host().get(occlusion + budget + more);
      ASSERT_EQ(response.status, 200) << response.body;
      const std::string address = header(response, "Content-Location").value_or("");
      EXPECT_TRUE(std::regex_search(address, std::regex("&samples=[0-9]+$"))) << address;
      EXPECT_EQ(address.find("budget_ms"), address.npos);
      EXPECT_EQ(address.find("max_rays"), address.npos);
      const Response there = other.get(address);
      ASSERT_EQ(there.status, 200) << there.body;
      EXPECT_TRUE(there.body == response.body) << address;
      EXPECT_EQ(header(there, "ETag"), header(response, "ETag"));
      EXPECT_EQ(header(response, "Cache-Control"), "no-cache");
      EXPECT_EQ(header(host().get(address), "Cache-Status"), "Tia; hit") << "it is kept by its tag";
      EXPECT_EQ(host()
                    .get(occlusion + budget + more, {{"If-None-Match", *header(response, "ETag")}})
                    .status,
                304);
    }
  }
}

// The samples that it came to, with the noise that ended some pixels before, are in its recipe.
TEST(Rounds, APngOfABudgetTellsWhatDrawsItAgain) {
  Config config;
  config.cache_bytes = 0;
  Host other(config);
  for (const std::string more : {"", R"(,"noise":0.005)", R"(,"noise":0.005,"denoise":true)"}) {
    const Response response =
        host().post("/render", R"({"scene":"shapes","integrator":"path","width":30,)"
                               R"("height":20,"max_rays":100000,"samples":4000)" +
                                   more + "}");
    ASSERT_EQ(response.status, 200) << response.body;
    EXPECT_FALSE(header(response, "Content-Location")) << "a body has no address";
    const std::string recipe = recipe_text(response.body);
    EXPECT_EQ(recipe.find("max_rays"), std::string::npos);
    const int most = samples_of(response).most;
    EXPECT_LT(most, 4000);
    EXPECT_THAT(recipe, testing::HasSubstr("\"samples\":" + std::to_string(most)));
    EXPECT_EQ(recipe.find("\"noise\":0.005") != recipe.npos, !more.empty());
    const Response again = other.post("/render", response.body, "image/png");
    EXPECT_TRUE(again.body == response.body);
    EXPECT_EQ(header(again, "ETag"), header(response, "ETag"));
    EXPECT_EQ(
        text_at(parse_json(other.post("/verify", response.body, "image/png").body), "verdict"),
        "same");
  }
}

TEST(Rounds, TimeThatIsNotEnoughForOneIs503) {
  const Response response =
      host().get("/render?scene=shapes&integrator=path&width=1280&height=960&budget_ms=1");
  EXPECT_EQ(response.status, 503);
  const Problem problem = problem_of(response);
  EXPECT_EQ(problem.type, "/problems/budget");
  EXPECT_THAT(problem.detail, testing::HasSubstr("16 samples"));
}

TEST(Rounds, RaysThatAreNotEnoughForOneAreALimit) {
  const ProblemError error = only_error(host().get(occlusion + "&max_rays=19199"));
  EXPECT_EQ(error.pointer, "/max_rays");
  EXPECT_EQ(error.got, Value(19199));
}

TEST(Rounds, TimeEndsThemInTime) {
  const Response response = host().get(
      "/render?scene=shapes&integrator=path&width=16&height=12&samples=65536&budget_ms=300");
  ASSERT_EQ(response.status, 200) << response.body;
  EXPECT_GE(samples_of(response).least, 16);
  EXPECT_LT(samples_of(response).most, 65536);
  EXPECT_EQ(samples_of(response).least, samples_of(response).most);
}

// A scene's own noise is of its own integrator, and gives way to a threshold that is asked for.
TEST(Rounds, TheScenesNoiseIsForItsOwnIntegrator) {
  const auto with = [](const std::string& more) {
    return host().post("/render", R"({"width":16,"height":12,"scene":{"background":0.5,
        "options":{"integrator":"path","noise":0.1}})" +
                                      more + "}");
  };
  EXPECT_TRUE(header(with(""), "Tia-Noise"));
  for (const char* other : {R"(,"integrator":"normal")", R"(,"integrator":"whitted")",
                            R"(,"threshold":0.1)", R"(,"noise":0)"}) {
    const Response response = with(other);
    EXPECT_EQ(response.status, 200) << response.body;
    EXPECT_FALSE(header(response, "Tia-Noise")) << other;
  }
  const ProblemError error = only_error(host().post("/scenes", R"({"options":{"noise":0.1}})"));
  EXPECT_EQ(error.pointer, "/options/noise");
}

}  // namespace
}  // namespace tia::test
