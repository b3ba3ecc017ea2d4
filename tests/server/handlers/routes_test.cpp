// Methods and paths: 404, 405 with Allow, 414.
#include "tests/server/support.h"

namespace tia::test {
namespace {

using testing::HasSubstr;

constexpr const char* methods[] = {"GET",   "HEAD",   "POST",    "PUT",
                                   "PATCH", "DELETE", "OPTIONS", "TRACE"};

struct Path {
  const char* law;
  const char* path;
  const char* allow;
  int answered = 200, posted = 200;  // what an empty object, or no parameter, comes to
  int deleted = 404;
};
void PrintTo(const Path& path, std::ostream* out) { *out << path.path; }

class Allow : public testing::TestWithParam<Path> {};

TEST_P(Allow, NamesTheMethodsThatThePathTakes) {
  const std::string allow = GetParam().allow;
  for (const char* method : methods) {
    SCOPED_TRACE(method);
    const Response response = host().ask(method, GetParam().path, "{}");
    if (std::string_view(method) == "OPTIONS") {
      EXPECT_EQ(response.status, 204);
      EXPECT_EQ(header(response, "Allow"), allow);
      EXPECT_EQ(response.content_type + response.body, "");
      continue;
    }
    const bool taken =
        (std::string(", ") + allow + ",").find(std::string(", ") + method + ",") != allow.npos;
    if (taken) {
      const std::string_view is = method;
      EXPECT_EQ(response.status, is == "POST"     ? GetParam().posted
                                 : is == "DELETE" ? GetParam().deleted
                                                  : GetParam().answered)
          << response.body;
      continue;
    }
    EXPECT_EQ(response.status, 405);
    EXPECT_EQ(header(response, "Allow"), allow);
    const Problem problem = problem_of(response);
    EXPECT_EQ(problem.type, "/problems/method");
    EXPECT_THAT(problem.detail, HasSubstr(method));
    EXPECT_THAT(problem.detail, HasSubstr(allow));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Of, Allow,
    testing::Values(Path{"Page", "/", "GET, HEAD, OPTIONS"},
                    Path{"Render", "/render", "GET, HEAD, POST, OPTIONS"},
                    Path{"Scenes", "/scenes", "GET, HEAD, POST, OPTIONS", 200, 201},
                    Path{"Models", "/models", "GET, HEAD, POST, OPTIONS", 200, 415},
                    Path{"Model", "/models/part", "GET, HEAD, DELETE, OPTIONS", 200, 405, 401},
                    Path{"ModelScene", "/models/part/scene", "GET, HEAD, OPTIONS"},
                    Path{"Still", "/still", "GET, HEAD, POST, OPTIONS", 422, 415},
                    Path{"Explain", "/explain", "GET, HEAD, POST, OPTIONS", 422, 422},
                    Path{"Compare", "/compare", "POST, OPTIONS", 405, 422},
                    Path{"Simulate", "/simulate", "POST, OPTIONS", 405, 422},
                    Path{"Jobs", "/jobs", "GET, HEAD, POST, OPTIONS", 401, 422},
                    Path{"JobLoad", "/jobs/load", "GET, HEAD, DELETE, OPTIONS"},
                    Path{"RadioPaths", "/radio/paths", "POST, OPTIONS", 405, 422},
                    Path{"RadioMap", "/radio/map", "GET, HEAD, POST, OPTIONS", 422, 422},
                    Path{"Scene", "/scenes/thesis", "GET, HEAD, DELETE, OPTIONS"},
                    Path{"Schema", "/schema/scene.json", "GET, HEAD, OPTIONS"},
                    Path{"Health", "/healthz", "GET, HEAD, OPTIONS"},
                    Path{"Version", "/version", "GET, HEAD, OPTIONS"},
                    Path{"OpenApi", "/openapi.json", "GET, HEAD, OPTIONS"},
                    Path{"Docs", "/docs", "GET, HEAD, OPTIONS"},
                    Path{"Problem", "/problems/busy", "GET, HEAD, OPTIONS", 308},
                    Path{"PageFile", "/style.css", "GET, HEAD, OPTIONS"},
                    Path{"PageFileInAFolder", "/panels/hand.js", "GET, HEAD, OPTIONS"}),
    law_of);

TEST(Routes, AnUnknownPathIs404ForEveryMethod) {
  for (const char* path : {"/nowhere", "/renderer", "/render/", "/Render", "/docs/index.html",
                           "/scenes/", "/scenes/a/b", "/schema", "/style.css/", "/web/style.css",
                           "/panels", "/panels/", "/panels/style.css", "/panels/hand.js/x"})
    for (const char* method : methods) {
      SCOPED_TRACE(std::string(method) + " " + path);
      const Response response = host().ask(method, path, "{}");
      EXPECT_EQ(response.status, 404);
      EXPECT_EQ(problem_of(response).type, "/problems/not-found");
    }
}

TEST(Routes, OptionsOfTheServerAreAllMethods) {  // RFC 9110, 9.3.7
  const Response response = host().ask("OPTIONS", "*");
  EXPECT_EQ(response.status, 204);
  EXPECT_EQ(header(response, "Allow"), "GET, HEAD, POST, DELETE, OPTIONS");
  EXPECT_EQ(host().get("*").status, 404);
}

TEST(Routes, NoPathLeadsToAFileOfTheMachine) {
  for (const char* path : {"/../etc/passwd", "/..%2f..%2fetc/passwd", "/%2e%2e/%2e%2e/etc/passwd",
                           "//etc/passwd", "/scenes/..%2f..%2fetc%2fpasswd", "/./style.css",
                           "/scenes/%2e%2e", "/style.css%00.js", "/etc/passwd", "/.git/config"}) {
    SCOPED_TRACE(path);
    EXPECT_EQ(host().get(path).status, 404);
  }
}

TEST(Routes, AnUnknownSceneIs404AndNamesTheKnownOnes) {
  const Response response = host().get("/scenes/thesi");
  EXPECT_EQ(response.status, 404);
  EXPECT_EQ(problem_of(response).type, "/problems/not-found");
  EXPECT_THAT(problem_of(response).detail, HasSubstr("thesis"));
}

// A URL of that many bytes, filled up with empty parameters.
std::string url_of(std::size_t bytes) {
  std::string target = "/render?width=8&height=8";
  return target.append(bytes - target.size(), '&');
}

TEST(Routes, AUrlOf4KiBIsReadAndOneByteMoreIs414NamingThePostForm) {
  EXPECT_EQ(host().get(url_of(4096)).status, 200);
  const Response response = host().get(url_of(4097));
  EXPECT_EQ(response.status, 414);
  EXPECT_THAT(problem_of(response).detail, HasSubstr("4096"));
  EXPECT_THAT(problem_of(response).detail, HasSubstr("POST /render"));
}

TEST(Routes, ALongPathIs414Too) {
  EXPECT_EQ(host().get(std::string("/") + std::string(4095, 'a')).status, 404);
  EXPECT_EQ(host().get(std::string("/") + std::string(4096, 'a')).status, 414);
  EXPECT_EQ(host().ask("POST", std::string("/") + std::string(1 << 20, 'a')).status, 414);
}

}  // namespace
}  // namespace tia::test
