// What operators ask: /readyz and /metrics.
#include <httplib.h>

#include <map>
#include <set>
#include <sstream>

#include "server/handlers/dispatch.h"
#include "server/http/application.h"
#include "tests/server/process_support.h"

namespace tia::test {
namespace {

std::map<std::string, double> metrics_of(Host& host) {
  const Response response = host.get("/metrics");
  EXPECT_EQ(response.status, 200);
  EXPECT_EQ(response.content_type, "text/plain; version=0.0.4; charset=utf-8");
  return series_of(response.body);
}

TEST(Metrics, CountRaysAsTheAnswersTellThem) {
  Host host;
  const std::string target = "/render?key=a&width=40&height=30&seed=";
  std::map<std::string, double> rays;
  for (int i = 0; i < 3; ++i) {
    std::istringstream list(*header(host.get(target + std::to_string(i)), "Tia-Rays"));
    for (std::string each; std::getline(list >> std::ws, each, ',');)
      rays[each.substr(0, each.find('='))] += std::stod(each.substr(each.find('=') + 1));
  }
  EXPECT_EQ(rays["primary"], 3 * 40 * 30);
  auto metrics = metrics_of(host);
  for (const auto& [kind, count] : rays)
    EXPECT_EQ(metrics["tia_rays_total{kind=\"" + kind + "\"}"], count) << kind;
}

TEST(Metrics, ObserveEveryPhaseOfAPicture) {
  Host host;
  for (int i = 0; i < 4; ++i) host.get("/render?width=8&height=8&seed=" + std::to_string(i));
  host.get("/render?width=0");
  auto metrics = metrics_of(host);
  for (const char* phase : {"queue", "wait", "parse", "build", "trace", "encode"}) {
    const std::string of = std::string("{phase=\"") + phase + "\"";
    EXPECT_EQ(metrics["tia_picture_phase_seconds_count" + of + "}"], 4);
    EXPECT_EQ(metrics["tia_picture_phase_seconds_bucket" + of + ",le=\"+Inf\"}"], 4);
    EXPECT_LT(metrics["tia_picture_phase_seconds_sum" + of + "}"], 60);
  }
}

std::set<std::string> families_of(const std::string& text) {
  std::set<std::string> names;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (!line.starts_with('#')) names.insert(line.substr(0, line.find_first_of("{ ")));
  return names;
}

TEST(Metrics, AreAllThereBeforeTheFirstRequest) {
  Host host;
  const std::set<std::string> first = families_of(host.get("/metrics").body);
  EXPECT_TRUE(first.contains("tia_requests_total"));
  host.get("/render?width=8&height=8");
  host.get("/none");
  EXPECT_EQ(families_of(host.get("/metrics").body), first);
}

TEST(Metrics, CountRequestsByRouteAndStatus) {
  Host host;
  for (const char* target :
       {"/render?width=8&height=8", "/render?width=8&height=9", "/render?width=0", "/scenes/thesis",
        "/scenes/none", "/x", "/style.css"}) {
    const Request request{"GET", target, {}, "", Host::id};
    const Response response = host.ask(request);
    host.service().metrics.count(Exchange{request, response, response.body.size(), 1},
                                 route_label(request));
  }
  auto metrics = metrics_of(host);
  const auto count = [&](const char* route, const char* status) {
    return metrics[std::string("tia_requests_total{route=\"") + route + "\",status=\"" + status +
                   "\"}"];
  };
  EXPECT_EQ(count("/render", "200"), 2);
  EXPECT_EQ(count("/render", "422"), 1);
  EXPECT_EQ(count("/scenes/{}", "200"), 1);
  EXPECT_EQ(count("/scenes/{}", "404"), 1);
  EXPECT_EQ(count("none", "404"), 1);
  EXPECT_EQ(count("/{}", "200"), 1);
}

TEST(Metrics, TellOfKeptScenesAndTheBuild) {
  Host host;
  host.post("/scenes", R"({"objects":[]})");
  auto metrics = metrics_of(host);
  EXPECT_EQ(metrics["tia_kept_scenes"], 1);
  EXPECT_EQ(metrics["tia_kept_scenes_bytes"], static_cast<double>(host.kept().bytes()));
  int builds = 0;
  for (const auto& [name, value] : metrics) builds += name.rfind("tia_build_info{", 0) == 0 ? 1 : 0;
  EXPECT_EQ(builds, 1);
}

// A counter that only appears with its first event has no rate for it.
TEST(Metrics, AllFamiliesAreThereBeforeTheFirstRequest) {
  const auto families = [](const std::string& text) {
    std::set<std::string> names;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
      if (line.starts_with("# TYPE ")) names.insert(line);
    return names;
  };
  const Tia tia;
  const std::string first = tia.get("/metrics").body;
  for (const char* target : {"/render?width=8&height=8", "/render?width=8&height=8", "/nowhere",
                             "/explain?x=1&y=1", "/render?scene=steiner&width=8&height=8"})
    tia.get(target);
  tia.client().Post("/scenes", "{}", "application/json");
  const std::set<std::string> before = families(first);
  EXPECT_GT(before.size(), 15U);
  EXPECT_EQ(families(tia.get("/metrics").body), before);
  const auto series = series_of(first);
  for (const char* holder :
       {"program", "connections", "requests", "pictures", "geometries", "scenes"})
    EXPECT_TRUE(series.contains(std::string("tia_memory_bytes{for=\"") + holder + "\"}")) << holder;
  for (const char* result : {"waited", "refused"})
    EXPECT_TRUE(series.contains(std::string("tia_memory_claims_total{result=\"") + result + "\"}"));
  EXPECT_TRUE(series.contains("tia_memory_limit_bytes"));
}

TEST(Ready, UntilTheServerGoesDown) {
  Host host;
  EXPECT_EQ(host.get("/readyz").status, 200);
  host.service().draining = true;
  EXPECT_EQ(host.get("/readyz").status, 503);
  EXPECT_EQ(host.get("/healthz").status, 200);  // it lives, and answers what still comes
}

}  // namespace
}  // namespace tia::test
