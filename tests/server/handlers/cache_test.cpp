// What a picture is called before it is drawn, and what is spared for it: entity tags, 304, the
// cache, and what is said of them.
#include <regex>
#include <set>

#include "server/stores/digest.h"
#include "tests/server/requests/recipe_support.h"
#include "tests/server/socket_support.h"

namespace tia::test {
namespace {

constexpr const char* little = "/render?width=37&height=23";

std::string said(const Response& response, const char* name) {
  return header(response, name).value_or("");
}
std::string etag_of(const std::string& target) { return said(host().head(target), "ETag"); }

// ---- the entity tag -------------------------------------------------------------------------

TEST(PictureTag, IsTheSha256OfTheRecipeInThePicture) {
  for (const char* query : {"", "&key=a", "&scene=shapes&samples=2&seed=3", "&crop=3,2,20,10"}) {
    const Response response = host().get(std::string(little) + query);
    EXPECT_EQ(said(response, "ETag"), '"' + sha256_hex(recipe_text(response.body)) + '"') << query;
    EXPECT_EQ(said(response, "ETag"), etag_of(std::string(little) + query));
  }
}

TEST(PictureTag, IsTheSameForTheSameRequestInOtherWords) {
  const std::string whole = url_encode(canonical_text(*host().gallery().find("thesis")));
  const std::vector<std::vector<std::string>> same{
      {"", "scene=thesis", "width=640", "width=640&height=480&samples=1", "threads=3", "format=png",
       "crop=0,0,640,480", "seed=0", "integrator=thesis", "camera=%7B%7D", "v=" + version(),
       "scene=" + whole, "transfer=linear", "threshold=0"},
      {"key=a", "light=-20,20,-10", "light=[-20,20,-10]&scene=thesis", "light=-2e1,20.0,-10"},
      {"format=pfm", "format=pfm&threads=1"},
      {"format=hdr", "format=hdr&threads=1"},
      {"format=exr", "format=exr&aov=rgba&depth=16"},
      {"format=exr&aov=Z,rgba", "format=exr&aov=rgba,%20Z"}};
  std::set<std::string> all;
  for (const auto& group : same) {
    std::set<std::string> tags;
    for (const std::string& query : group) tags.insert(etag_of("/render?" + query));
    EXPECT_EQ(tags.size(), 1U) << testing::PrintToString(group);
    all.merge(tags);
  }
  EXPECT_EQ(all.size(), same.size());
}

TEST(PictureTag, IsTheSameWhetherItIsAskedForWithGetOrPost) {
  const Response got = host().get(std::string(little) + "&key=s");
  const Response posted = host().post("/render", R"({"height":23,"key":"s","width":37})");
  EXPECT_EQ(said(got, "ETag"), said(posted, "ETag"));
  EXPECT_TRUE(got.body == posted.body);
}

TEST(PictureTag, IsAnotherForAnotherPicture) {
  const std::vector<std::string> queries{"",
                                         "key=a",
                                         "key=d",
                                         "width=639",
                                         "height=479",
                                         "format=pfm",
                                         "format=hdr",
                                         "format=exr",
                                         "format=exr&aov=Z",
                                         "format=exr&depth=32",
                                         "samples=2",
                                         "seed=1",
                                         "max_depth=1",
                                         "transfer=srgb",
                                         "transfer=aces",
                                         "exposure=0.5",
                                         "white_balance_kelvin=3000",
                                         "integrator=whitted",
                                         "threshold=0.1",
                                         "scene=shapes",
                                         "crop=0,0,639,480",
                                         "camera=%7B%22fov_degrees%22:40%7D",
                                         "light=1,2,3"};
  std::set<std::string> tags;
  for (const std::string& query : queries) tags.insert(etag_of("/render?" + query));
  EXPECT_EQ(tags.size(), queries.size());
}

// ---- 304 ------------------------------------------------------------------------------------

TEST(Conditional, APictureThatTheClientHasCostsNoRay) {
  const std::string etag = etag_of(little);
  EXPECT_TRUE(std::regex_match(etag, std::regex("\"[0-9a-f]{64}\""))) << etag;
  Host stopped;
  stopped.stop();  // whatever traces a ray is 503
  for (const std::string& has : {etag, "W/" + etag, "\"x\", " + etag, std::string("*")}) {
    const Response response = stopped.get(little, {{"If-None-Match", has}});
    EXPECT_EQ(response.status, 304) << has;
    EXPECT_EQ(response.body, "");
    EXPECT_EQ(response.content_type, "");
    EXPECT_EQ(said(response, "ETag"), etag);
    EXPECT_EQ(said(response, "Cache-Control"), "no-cache");
    EXPECT_EQ(said(response, "Vary"), "Accept");
  }
  EXPECT_EQ(stopped.ask("HEAD", little, "", {{"If-None-Match", etag}}).status, 304);
  EXPECT_EQ(stopped.get(little, {{"If-None-Match", "\"x\""}}).status, 503);
}

TEST(Conditional, OtherPicturesAndPostsAreSent) {
  const std::string etag = etag_of(little);
  EXPECT_EQ(host().get(std::string(little) + "&key=a", {{"If-None-Match", etag}}).status, 200);
  EXPECT_EQ(host()
                .ask("POST", "/render", R"({"width":37,"height":23})",
                     {{"If-None-Match", etag}, {"Content-Type", "application/json"}})
                .status,
            200);
  EXPECT_EQ(host().get("/render?width=0", {{"If-None-Match", "*"}}).status, 422);
}

TEST(Conditional, AnswersOverASocketHaveNoBodyAndNoLength) {
  Server server;
  Connection connection(server.port());
  const std::string etag = etag_of(little);
  for (int i = 0; i < 3; ++i) {
    connection.send(std::string("GET ") + little +
                    " HTTP/1.1\r\nHost: x\r\nIf-None-Match: " + etag + "\r\n\r\n");
    const Response response = connection.receive();
    EXPECT_EQ(response.status, 304);
    EXPECT_EQ(header(response, "Content-Length"), std::nullopt);  // RFC 9110, 8.6
  }
}

// ---- the cache ------------------------------------------------------------------------------

TEST(Cache, APictureIsDrawnOnceAndTheSameBytesAfterwards) {
  Host host;
  const Response first = host.get(little), again = host.get(little);
  EXPECT_EQ(said(first, "Cache-Status"), "Tia; fwd=miss; stored");
  EXPECT_EQ(said(again, "Cache-Status"), "Tia; hit");
  EXPECT_TRUE(first.body == again.body);
  EXPECT_EQ(said(first, "Tia-Rays"), said(again, "Tia-Rays"));
  EXPECT_THAT(said(again, "Server-Timing"), testing::HasSubstr("trace;dur=0.000"));
  EXPECT_EQ(host.post("/render", R"({"width":37,"height":23})").body, first.body);
  const auto metrics = series_of(host.get("/metrics").body);
  EXPECT_EQ(metrics.at("tia_rays_total{kind=\"primary\"}"), 37 * 23);
  EXPECT_EQ(metrics.at("tia_cache_lookups_total{result=\"hit\"}"), 2);
  EXPECT_EQ(metrics.at("tia_cache_lookups_total{result=\"miss\"}"), 1);
  EXPECT_EQ(metrics.at("tia_cache_pictures"), 1);
  EXPECT_GT(metrics.at("tia_cache_bytes"), first.body.size());
}

TEST(Cache, OfNoBytesDrawsEachPictureAnew) {
  Config config;
  config.cache_bytes = 0;
  Host host(config);
  const Response first = host.get(little), again = host.get(little);
  EXPECT_EQ(said(first, "Cache-Status"), "Tia; fwd=miss");
  EXPECT_EQ(said(again, "Cache-Status"), "Tia; fwd=miss");
  EXPECT_TRUE(first.body == again.body);
}

TEST(Cache, KeepsNoRefusal) {
  Config config;
  config.max_rays = 20 * 20;
  Host host(config);
  const char* const lit = "/render?width=20&height=20&key=a";  // shadow rays come on top
  for (int i = 0; i < 2; ++i) EXPECT_EQ(host.get(lit).status, 422);
  EXPECT_EQ(series_of(host.get("/metrics").body).at("tia_cache_pictures"), 0);
}

TEST(Cache, TellsOthersWhatTheyMayKeep) {
  const auto policy = [](const std::string& more) {
    return said(host().get(little + more), "Cache-Control");
  };
  EXPECT_EQ(policy(""), "no-cache");
  for (const std::string& v : {version(), full_version(), url_encode(full_version())})
    EXPECT_EQ(policy("&v=" + v), "public, max-age=31536000, immutable") << v;
  const ProblemError other = only_error(host().get(std::string(little) + "&v=0.0.1"));
  EXPECT_EQ(other.pointer, "/v");
  EXPECT_THAT(other.allowed, testing::HasSubstr(full_version()));
}

// Objects that are too many to be told still tell one picture from another.
TEST(Cache, TellsPicturesOfManyObjectsApart) {
  const auto mesh = [](double x) {
    std::string positions, indices;
    for (int i = 0; i < 15'000; ++i) {
      positions += (i > 0 ? "," : "") + number_text(x + i % 7) + ",0,-9";
      indices += (i > 0 ? "," : "") + std::to_string(i);
    }
    return R"({"objects":[{"type":"mesh","positions":[)" + positions + R"(],"indices":[)" +
           indices + "]}]}";
  };
  const auto drawn = [](const std::string& scene) {
    return host().post("/render", R"({"width":8,"height":8,"scene":)" + scene + "}");
  };
  const Response a = drawn(mesh(0)), b = drawn(mesh(1)), again = drawn(mesh(0));
  EXPECT_NE(said(a, "ETag"), said(b, "ETag"));
  EXPECT_EQ(said(a, "ETag"), said(again, "ETag"));
  EXPECT_EQ(said(again, "Cache-Status"), "Tia; hit");
  EXPECT_LT(a.body.size(), 2000U);
  const ProblemError untold = only_error(host().post("/render", a.body, "image/png"));
  EXPECT_EQ(untold.pointer, "/scene/objects");
}

}  // namespace
}  // namespace tia::test
