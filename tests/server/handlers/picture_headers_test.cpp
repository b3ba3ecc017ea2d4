// What stands beside a picture: exact ray counts, times, ids; and HEAD, which draws nothing.
#include <cstdio>
#include <map>
#include <regex>

#include "tests/server/picture_support.h"
#include "tests/server/support.h"

namespace tia::test {
namespace {

RayCounts rays_of(const Response& response) {
  const std::string text = header(response, "Tia-Rays").value_or("");
  long long n[4] = {};
  const int read =
      std::sscanf(text.c_str(), "primary=%lld, shadow=%lld, reflection=%lld, refraction=%lld",
                  &n[0], &n[1], &n[2], &n[3]);
  EXPECT_EQ(read, 4) << text;
  return {.primary = n[0], .shadow = n[1], .reflection = n[2], .refraction = n[3]};
}

// The thesis picture with a light, one ray at a time, in the scalar asked for.
RayCounts traced(const Vec3d& light, int width, int height, Scalar scalar) {
  const Scene scene = with_light(*host().gallery().find("thesis"), light);
  const World world = compile(scene);
  const RenderOptions options{.scalar = scalar};
  return render(world, view_of(scene.camera, width, height), {0, 0, width, height}, options,
                host().pool(), {}, [](const FilmTile&) {})
      .rays;
}

TEST(TiaRays, AnUnlitPictureHasOnePrimaryRayAPixelAndNoOther) {
  EXPECT_EQ(rays_of(host().get("/render")), (RayCounts{.primary = 307'200}));
  EXPECT_EQ(rays_of(host().get("/render?width=37&height=23")), (RayCounts{.primary = 851}));
  EXPECT_EQ(rays_of(host().get("/render?width=37&height=23&crop=30,20,37,23")),
            (RayCounts{.primary = 21}));
}

TEST(TiaRays, ALitPictureCountsOneShadowRayForEachHitThatFacesTheLight) {
  const RayCounts rays = rays_of(host().get("/render?light=-20,20,-10&width=160&height=120"));
  EXPECT_EQ(rays, traced({-20, 20, -10}, 160, 120, Scalar::narrow));
  EXPECT_GT(rays.shadow, 0);
  EXPECT_LT(rays.shadow, rays.primary);
  // In double a hit at the terminator may fall on the other side, no more.
  const auto exact = traced({-20, 20, -10}, 160, 120, Scalar::exact);
  EXPECT_NEAR(static_cast<double>(rays.shadow), static_cast<double>(exact.shadow), 20);
}

TEST(TiaRays, EveryPixelThatIsLitHadAShadowRay) {
  const Response response = host().get("/render?key=a&width=160&height=120&format=pfm");
  const auto light = decode_pfm(response.body);
  std::int64_t lit = 0;
  for (std::size_t i = 0; i < light.rgb.size(); i += 3)
    if (light.rgb[i] > 0 && light.rgb[i] != 0.8F) ++lit;  // neither dark nor background
  EXPECT_GT(lit, 1000);
  EXPECT_LE(lit, rays_of(response).shadow);
}

TEST(TiaRays, TheCountsOfWindowsThatTileThePictureAddUpToItsOwn) {
  const std::string full = "/render?key=s&width=101&height=67";
  RayCounts sum;
  for (const char* crop : {"0,0,40,30", "40,0,101,30", "0,30,40,67", "40,30,101,67"}) {
    const RayCounts part = rays_of(host().get(full + "&crop=" + crop));
    sum.primary += part.primary;
    sum.shadow += part.shadow;
  }
  EXPECT_EQ(rays_of(host().get(full)), sum);
}

TEST(TiaRays, TheCountDoesNotDependOnFormatOrThreads) {
  const std::string full = "/render?key=d&width=101&height=67";
  const RayCounts rays = rays_of(host().get(full));
  EXPECT_EQ(rays_of(host().get(full + "&format=pfm")), rays);
  EXPECT_EQ(rays_of(host().get(full + "&threads=7")), rays);
}

// A room of which every path is cut at its second wall.
TEST(TiaRays, TellOfPathsThatWereCut) {
  const auto drawn = [](const std::string& options) {
    return host().post("/render",
                       R"({"width": 8, "height": 6, "scene": {"objects": [{"type": "sphere",
      "center": [0, 0, 0], "radius": 2, "material": {"color": [1, 1, 1], "diffuse": 0.5, "emission": [1, 1, 1]}}],
      "options": {)" + options +
                           "}}}");
  };
  const Response path = drawn(R"("integrator": "path", "samples": 4, "max_depth": 1)");
  EXPECT_EQ(header(path, "Tia-Rays"),
            "primary=192, shadow=0, reflection=192, refraction=0, cut=192");
  EXPECT_EQ(header(path, "Tia-Biased"), std::nullopt);
  EXPECT_EQ(header(drawn(R"("max_depth": 1)"), "Tia-Rays"),
            "primary=48, shadow=48, reflection=0, refraction=0");
  // What darkens bright samples is told as well, where it does.
  const std::string clamped = R"("integrator": "path", "samples": 4, "max_depth": 1, "clamp": 1)";
  EXPECT_EQ(header(drawn(clamped), "Tia-Biased"), "clamp");
  EXPECT_EQ(header(drawn(clamped), "Tia-Biased"), "clamp");  // kept, too
  EXPECT_EQ(header(drawn(R"("clamp": 1)"), "Tia-Biased"), std::nullopt);
}

TEST(ServerTiming, HasTheWaitForMemoryAndTheFivePhasesInMilliseconds) {
  const std::string text = header(host().get("/render?width=8&height=8"), "Server-Timing").value();
  const std::string number = R"(\d+(\.\d+)?)";
  std::string form;
  for (const char* phase : {"queue", "wait;desc=memory", "parse", "build", "trace", "encode"})
    form += (form.empty() ? "" : ", ") + std::string(phase) + ";dur=" + number;
  EXPECT_TRUE(std::regex_match(text, std::regex(form))) << text;
}

TEST(Answer, EveryAnswerCarriesTheRequestsId) {
  for (const char* target : {"/render?width=8&height=8", "/render?width=0", "/", "/scenes",
                             "/healthz", "/nowhere", "/style.css", "/version"})
    EXPECT_EQ(header(host().get(target), "X-Request-Id"), Host::id) << target;
}

TEST(Head, RendersNothingAndHasNoBody) {
  Host stopped;
  stopped.stop();
  for (const char* target : {"/render", "/render?key=a&format=png", "/render?light=1,2,3"}) {
    SCOPED_TRACE(target);
    EXPECT_EQ(stopped.get(target).status, 503);
    const Response response = stopped.head(target);
    EXPECT_EQ(response.status, 200);
    EXPECT_EQ(response.content_type, "image/png");
    EXPECT_EQ(response.body, "");
  }
  EXPECT_EQ(stopped.head("/render?format=pfm").content_type, "image/x-portable-floatmap");
}

// A scene with fog and a clamp, which path heeds and no other.
std::string foggy(const std::string& integrator) {
  const std::string scene =
      R"({"fog":{"density":0.1},"objects":[{"type":"sphere","center":[0,0,-5],)"
      R"("radius":1}],"options":{"clamp":1,"integrator":")" +
      integrator + R"(","samples":16}})";
  return "/render?width=8&height=6&scene=" + url_encode(scene);
}

TEST(TiaIgnored, NamesWhatTheIntegratorLeavesOut) {
  for (const char* other : {"whitted", "thesis", "depth", "ambient_occlusion"}) {
    EXPECT_EQ(header(host().get(foggy(other)), "Tia-Ignored"), "/fog, /options/clamp") << other;
    EXPECT_EQ(header(host().get(foggy(other)), "Tia-Biased"), std::nullopt) << other;
  }
  const Response path = host().get(foggy("path"));
  EXPECT_EQ(header(path, "Tia-Ignored"), std::nullopt);
  EXPECT_EQ(header(path, "Tia-Biased"), "clamp");
  EXPECT_EQ(header(host().get("/render"), "Tia-Ignored"), std::nullopt);
}

// All of GET's headers but those of how the picture was drawn. Before and after it is kept.
TEST(Head, TellsWhatGetTells) {
  const auto told = [](const Response& response, bool has_budget) {
    std::map<std::string, std::string> headers;
    for (const auto& [name, value] : response.headers) headers[name] = value;
    for (const char* of_drawing : {"Server-Timing", "Tia-Rays", "Cache-Status", "Tia-Samples",
                                   "Tia-Noise", "Content-Location"})
      headers.erase(of_drawing);
    if (has_budget) headers.erase("ETag");
    return headers;
  };
  const Headers accepts{{"Accept", "image/vnd.radiance, */*;q=0.1"}};
  const std::string path = foggy("path");
  const std::string named = "/render?width=8&height=6&scene=street-lamp&integrator=whitted";
  for (const std::string& target : {path, named, foggy("whitted"), path + "&v=" + version(),
                                    path + "&noise=0.5", path + "&budget_ms=60000"}) {
    const bool has_budget = target.find("budget") != target.npos;
    for (int times = 0; times < 2; ++times) {
      const Response head = host().ask("HEAD", target, "", accepts),
                     get = host().get(target, accepts);
      EXPECT_EQ(told(head, has_budget), told(get, has_budget)) << target;
      EXPECT_TRUE(header(get, "Vary")) << target;
      EXPECT_EQ(head.content_type, get.content_type);
    }
  }
}

TEST(Head, FindsWhatGetWouldRefuse) {
  for (const char* query :
       {"width=0", "scene=nowhere", "key=q", "key=a&light=1,2,3", "no=1", "width=5000&height=5000",
        "samples=65536", "camera=%7B%7D0", "camera=%7B%22fov_degrees%22:0%7D", "crop=0,0,0,0",
        "key=%zz", "key=a&key=a"})
    EXPECT_EQ(host().head(std::string("/render?").append(query)).status,
              host().get(std::string("/render?").append(query)).status)
        << query;
}

}  // namespace
}  // namespace tia::test
