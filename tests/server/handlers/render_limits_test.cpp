// What a picture may ask for at most, and how many faults an answer names.
#include <cstdio>

#include "tests/server/support.h"

namespace tia::test {
namespace {

using testing::HasSubstr;

TEST(RenderLimits, APictureOf16777216PixelsIsDrawn) {
  for (const char* size :
       {"width=4096&height=4096", "width=16777216&height=1", "width=1&height=16777216"}) {
    SCOPED_TRACE(size);
    EXPECT_EQ(host().head(std::string("/render?").append(size)).status, 200);
    EXPECT_EQ(host().get(std::string("/render?").append(size) + "&crop=0,0,1,1").status, 200);
  }
}

TEST(RenderLimits, OneRowMoreNamesTheLimitAndItsOption) {
  const char* const json = R"({"width":4096,"height":4097})";
  const Response post = host().post("/render", json);
  EXPECT_EQ(post.status, 422);
  EXPECT_EQ(host().get("/render?width=4096&height=4097").body, post.body);
  EXPECT_EQ(host().head("/render?width=4096&height=4097").status, 422);
  EXPECT_EQ(problem_of(post).type, "/problems/limit");
  const ProblemError error = only_error(post);
  EXPECT_EQ(error.pointer, "/width");
  ASSERT_TRUE(error.got);
  EXPECT_EQ(*error.got, Value("4096 x 4097"));
  EXPECT_THAT(error.allowed, HasSubstr("16777216"));
  EXPECT_THAT(error.allowed, HasSubstr("TIA_MAX_PIXELS"));
}

TEST(RenderLimits, AWindowDoesNotMakeALargePictureSmall) {
  EXPECT_EQ(host().get("/render?width=4096&height=4097&crop=0,0,1,1").status, 422);
}

TEST(RenderLimits, TheProductOfTwoLargestSidesDoesNotWrapRound) {
  EXPECT_EQ(host().get("/render?width=16777216&height=16777216").status, 422);
  EXPECT_EQ(host().get("/render?width=65536&height=65536").status, 422);  // 2^32
}

TEST(RenderLimits, MaxPixelsIsTheOptionsNotAConstant) {
  Config config;
  config.max_pixels = 48;
  Host small(config);
  EXPECT_EQ(small.get("/render?width=8&height=6").status, 200);
  const Response beyond = small.get("/render?width=7&height=7");
  EXPECT_EQ(beyond.status, 422);
  EXPECT_THAT(only_error(beyond).allowed, HasSubstr("48"));
}

// ---- work ------------------------------------------------------------------------------------

TEST(RenderLimits, ObjectsThatOverlapByTheMillionAreRefusedNamingTheOption) {
  Config config;
  config.max_work = 1'000'000;
  Host host(config);
  const Response response = host.post("/render", R"({"width":8,"height":6,"scene":{"objects":[
      {"type":"group","repeat":{"count":[1000000,1,1],"step":[1e-6,1,1]},
       "children":[{"type":"sphere","center":[0,0,-9],"radius":2}]}]}})");
  EXPECT_EQ(response.status, 422);
  EXPECT_EQ(problem_of(response).type, "/problems/limit");
  EXPECT_EQ(only_error(response).pointer, "/scene");
  EXPECT_THAT(only_error(response).allowed, HasSubstr("TIA_MAX_WORK"));
}

// ---- rays ------------------------------------------------------------------------------------

Config with_rays(std::int64_t max_rays) {
  Config config;
  config.max_rays = max_rays;
  return config;
}
void expect_too_many_rays(const Response& response, const std::string& limit) {
  EXPECT_EQ(response.status, 422);
  EXPECT_EQ(problem_of(response).type, "/problems/limit");
  const ProblemError error = only_error(response);
  EXPECT_EQ(error.pointer, "/samples");
  EXPECT_THAT(error.allowed, HasSubstr(limit + " rays"));
  EXPECT_THAT(error.allowed, HasSubstr("TIA_MAX_RAYS"));
}

// 640 x 480 pixels of 6511 samples are 2 000 179 200 rays, of 6510 they are 1 999 872 000.
TEST(RenderLimits, RaysThatAreSureToComeAreRefusedBeforeTracing) {
  Host stopped;
  stopped.stop();
  EXPECT_EQ(stopped.get("/render?samples=6510").status, 503);
  expect_too_many_rays(stopped.get("/render?samples=6511"), "2000000000");
  expect_too_many_rays(stopped.post("/render", R"({"samples":6511})"), "2000000000");
  EXPECT_EQ(stopped.head("/render?samples=6510").status, 200);
  EXPECT_EQ(stopped.head("/render?samples=6511").status, 422);
}

TEST(RenderLimits, TheRaysOfAWindowAreThoseThatItTakes) {
  Host host(with_rays(12));  // 2 x 2 pixels of 3 samples, unlit
  const std::string picture = "/render?width=4096&height=4096&crop=0,0,2,2&samples=";
  EXPECT_EQ(host.get(picture + "3").status, 200);
  expect_too_many_rays(host.get(picture + "4"), "12");
}

// A threshold takes at least four samples.
TEST(RenderLimits, AThresholdsFirstRoundIsPredicted) {
  Host host(with_rays(15));
  EXPECT_EQ(host.head("/render?width=2&height=2&threshold=0.1").status, 422);
  expect_too_many_rays(host.get("/render?width=2&height=2&threshold=0.1"), "15");
  EXPECT_EQ(Host(with_rays(16)).get("/render?width=2&height=2&threshold=1").status, 200);
}

// The shadow rays of a lit picture cannot be predicted: they are counted.
TEST(RenderLimits, RaysThatComeWhileTracingAreCounted) {
  const std::string lit = "/render?key=a&width=64&height=48";
  Host host;
  const std::string counts = header(host.get(lit), "Tia-Rays").value();
  long long primary = 0, shadow = 0;
  ASSERT_EQ(std::sscanf(counts.c_str(), "primary=%lld, shadow=%lld", &primary, &shadow), 2);
  ASSERT_GT(shadow, 0);
  EXPECT_EQ(Host(with_rays(primary + shadow)).get(lit).status, 200);
  Host small(with_rays(primary + shadow - 1));
  EXPECT_EQ(small.head(lit).status, 200);
  expect_too_many_rays(small.get(lit), std::to_string(primary + shadow - 1));
}

TEST(RenderLimits, AllFaultsAreNamedAtOnce) {
  const Problem problem = problem_of(host().get("/render?width=0&height=abc&widh=8&format=gif"));
  std::vector<std::string> pointers;
  for (const ProblemError& error : problem.errors) pointers.push_back(error.pointer);
  EXPECT_THAT(pointers, testing::UnorderedElementsAre("/width", "/height", "/widh", "/format"));
  EXPECT_THAT(problem.detail, HasSubstr("4 faults"));
}

TEST(RenderLimits, TwentyFaultsAreNamedAndNoMore) {
  std::string nineteen, many;
  for (int i = 0; i < 500; ++i) {
    if (i == 19) nineteen = many;
    many += "&no" + std::to_string(i) + "=";
  }
  EXPECT_EQ(problem_of(host().get(std::string("/render?") + nineteen)).errors.size(), 19U);
  EXPECT_EQ(problem_of(host().get(std::string("/render?") + many)).errors.size(), 20U);
}

TEST(RenderLimits, AnAnswerDoesNotEchoALongValue) {
  const std::string body = R"({"scene":")" + std::string(500'000, 'x') + R"("})";
  const Response response = host().post("/render", body);
  EXPECT_EQ(response.status, 422);
  EXPECT_EQ(only_error(response).pointer, "/scene");
  EXPECT_LT(response.body.size(), 2000U);
}

TEST(RenderLimits, AnAnswerToManyUnknownNamesIsShortAndComesAtOnce) {
  std::string materials, objects;
  for (int i = 0; i < 2000; ++i) {
    const std::string name = std::string(50, 'n') + std::to_string(i), comma = i > 0 ? "," : "";
    materials += comma + "\"" + name + "\":{}";
    objects +=
        comma + R"({"type":"sphere","center":[0,0,0],"radius":1,"material":"x)" + name + "\"}";
  }
  const Response response = host().post(
      "/render", R"({"scene":{"materials":{)" + materials + R"(},"objects":[)" + objects + "]}}");
  EXPECT_EQ(response.status, 422);
  EXPECT_EQ(problem_of(response).errors.size(), 20U);
  EXPECT_LT(response.body.size(), 60'000U);
}

TEST(RenderLimits, AStoppedRenderIs503Draining) {
  std::stop_source stop;
  Request request{"GET", "/render?width=8&height=8", {}, "", Host::id};
  request.stop = stop.get_token();
  EXPECT_EQ(host().ask(request).status, 200);
  stop.request_stop();
  request.target += "&seed=1";
  const Response response = host().ask(request);
  EXPECT_EQ(response.status, 503);
  EXPECT_EQ(problem_of(response).type, "/problems/draining");
}

}  // namespace
}  // namespace tia::test
