// What every answer carries for browsers, and whom CORS lets read it.
#include "server/http/headers.h"

#include "tests/server/support.h"

namespace tia::test {
namespace {

using testing::HasSubstr;

constexpr const char* all_targets[] = {"/",        "/style.css",   "/main.js",
                                       "/scenes",  "/favicon.svg", "/render?width=8&height=8",
                                       "/healthz", "/nowhere",     "/render?width=0"};

TEST(Guard, EveryAnswerIsWhatItSaysItIsAndTellsNoOtherSite) {
  for (const char* target : all_targets) {
    const Response response = host().get(target);
    EXPECT_EQ(header(response, "X-Content-Type-Options"), "nosniff") << target;
    EXPECT_EQ(header(response, "Referrer-Policy"), "no-referrer") << target;
  }
}

TEST(Guard, ThePageLoadsNothingFromElsewhereAndStandsInNoFrame) {
  for (const char* target : {"/", "/index.html", "/favicon.svg"})
    EXPECT_EQ(header(host().get(target), "Content-Security-Policy"),
              "default-src 'none'; img-src 'self' blob: data:; script-src 'self'; style-src "
              "'self'; connect-src 'self'; base-uri 'none'; frame-ancestors 'none'");
}

TEST(Guard, OtherSitesMayShowPicturesAndLoadNothingElse) {
  for (const char* target : all_targets) {
    const Response response = host().get(target);
    const bool picture = response.content_type.starts_with("image/");
    EXPECT_EQ(header(response, "Cross-Origin-Resource-Policy"),
              picture ? "cross-origin" : "same-origin")
        << target;
  }
}

TEST(Guard, An304SaysNothingNewOfWhatTheClientHas) {
  const Response response = host().get("/", {{"If-None-Match", "*"}});
  EXPECT_EQ(response.status, 304);
  EXPECT_FALSE(header(response, "Cross-Origin-Resource-Policy"));
  EXPECT_FALSE(header(response, "Content-Security-Policy"));
}

TEST(Guard, ThePageHasNoScriptAndNoStyleInLine) {
  const std::string page = host().get("/").body;
  for (const char* inline_text : {"<style", "style=", " onclick", " onload", "javascript:"})
    EXPECT_THAT(page, Not(HasSubstr(inline_text)));
  for (std::size_t at = page.find("<script"); at != page.npos; at = page.find("<script", at + 1))
    EXPECT_THAT(page.substr(at, page.find("</script>", at) - at),
                testing::MatchesRegex("<script[^>]* src=\"[^>]*>"));
}

// ---- CORS -----------------------------------------------------------------------------------

Host& sharing() {
  static Host shared(
      read_config({{"cors_origins", "https://a.example,http://localhost:3000", "--cors-origins"}}));
  return shared;
}

constexpr const char* allow_origin = "Access-Control-Allow-Origin";

std::vector<std::string> cors_fields(const Response& response) {
  std::vector<std::string> names;
  for (const auto& [name, value] : response.headers)
    if (name.starts_with("Access-Control-")) names.push_back(name);
  return names;
}

Response preflight(Host& asked, const std::string& origin, const std::string& target,
                   const std::string& method = "POST") {
  return asked.ask("OPTIONS", target, "",
                   {{"Origin", origin},
                    {"Access-Control-Request-Method", method},
                    {"Access-Control-Request-Headers", "content-type"}});
}

TEST(Cors, IsOffUnlessAskedFor) {
  for (const char* target : all_targets) {
    const Response response = host().get(target, {{"Origin", "https://a.example"}});
    EXPECT_THAT(cors_fields(response), testing::IsEmpty()) << target;
    EXPECT_THAT(header(response, "Vary").value_or(""), Not(HasSubstr("Origin"))) << target;
  }
  const Response asked = preflight(host(), "https://a.example", "/render");
  EXPECT_EQ(asked.status, 204);
  EXPECT_THAT(cors_fields(asked), testing::IsEmpty());
}

TEST(Cors, AnOriginOfTheListMayReadEveryAnswerProblemsToo) {
  for (const char* origin : {"https://a.example", "http://localhost:3000"})
    for (const char* target : all_targets) {
      const Response response = sharing().get(target, {{"Origin", origin}});
      EXPECT_EQ(header(response, allow_origin), origin) << target;
      EXPECT_EQ(header(response, "Access-Control-Expose-Headers"),
                "ETag, Server-Timing, Tia-Rays, Tia-Delete-Key, X-Request-Id, traceparent, "
                "Retry-After, Cache-Status, Content-Location, Tia-Samples, Tia-Noise, Tia-Biased, "
                "Tia-Ignored, WWW-Authenticate, RateLimit-Policy, RateLimit");
      EXPECT_THAT(header(response, "Vary").value_or(""), HasSubstr("Origin")) << target;
    }
}

TEST(Cors, NoOtherOriginMay) {
  for (const char* origin : {"https://b.example", "http://a.example", "https://a.example:8443",
                             "https://a.example.b", "null", "*", ""}) {
    const Response response = sharing().get("/healthz", {{"Origin", origin}});
    EXPECT_THAT(cors_fields(response), testing::IsEmpty()) << origin;
    EXPECT_EQ(header(response, "Vary"), "Origin");  // what a cache keeps may be for another
    EXPECT_THAT(cors_fields(preflight(sharing(), origin, "/render")), testing::IsEmpty());
  }
  EXPECT_EQ(header(sharing().get("/healthz"), "Vary"), "Origin");
}

TEST(Cors, AnyMayWhereAStarIsOnTheList) {
  Host open(read_config({{"cors_origins", "https://a.example,*", ""}}));
  for (const Headers& headers : {Headers{{"Origin", "https://b.example"}}, Headers{}}) {
    const Response response = open.get("/healthz", headers);
    EXPECT_EQ(header(response, allow_origin), "*");
    EXPECT_FALSE(header(response, "Vary"));  // the answer is the same for all
  }
}

TEST(Cors, APreflightNamesWhatThePathTakes) {
  const Response response = preflight(sharing(), "https://a.example", "/render");
  EXPECT_EQ(response.status, 204);
  EXPECT_EQ(response.body, "");
  EXPECT_EQ(header(response, allow_origin), "https://a.example");
  EXPECT_EQ(header(response, "Access-Control-Allow-Methods"), "GET, HEAD, POST, OPTIONS");
  EXPECT_EQ(header(response, "Access-Control-Allow-Headers"),
            "Content-Type, If-None-Match, X-Request-Id, Tia-Delete-Key, traceparent, "
            "Authorization");
  EXPECT_EQ(header(response, "Access-Control-Max-Age"), "7200");
  EXPECT_EQ(
      header(preflight(sharing(), "https://a.example", "/healthz"), "Access-Control-Allow-Methods"),
      "GET, HEAD, OPTIONS");
}

TEST(Cors, APreflightOfNoPathIs404) {
  EXPECT_EQ(preflight(sharing(), "https://a.example", "/nowhere").status, 404);
}

TEST(Cors, PlainOptionsAndOtherMethodsAreNoPreflight) {
  for (const char* method : {"OPTIONS", "PUT"}) {
    const Response response =
        sharing().ask(method, "/render", "", {{"Origin", "https://a.example"}});
    EXPECT_EQ(header(response, allow_origin), "https://a.example");
    EXPECT_FALSE(header(response, "Access-Control-Allow-Methods"));
  }
  const Response put =
      sharing().ask("PUT", "/render", "",
                    {{"Origin", "https://a.example"}, {"Access-Control-Request-Method", "POST"}});
  EXPECT_FALSE(header(put, "Access-Control-Allow-Methods"));
}

// ---- fields that are lists ------------------------------------------------------------------

TEST(Joined, IsOneListOfAllFieldsOfTheName) {
  const Request request{"GET", "/", {{"A", "1, 2"}, {"B", "x"}, {"a", "3"}}, "", ""};
  EXPECT_EQ(joined(request, "a"), "1, 2, 3");
  EXPECT_EQ(joined(request, "B"), "x");
  EXPECT_EQ(joined(request, "c"), "");
}

TEST(AddVary, MakesOneFieldOfAll) {
  Headers headers{{"ETag", "\"1\""}};
  add_vary(headers, "Accept");
  add_vary(headers, "Origin");
  EXPECT_EQ(headers, (Headers{{"ETag", "\"1\""}, {"Vary", "Accept, Origin"}}));
}

}  // namespace
}  // namespace tia::test
