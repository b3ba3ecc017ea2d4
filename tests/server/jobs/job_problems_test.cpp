// Which problems the routes of jobs answer with: each is provoked, and what comes is held against
// the OpenAPI document, as all answers of a Host are.
#include "tests/server/jobs/jobs_support.h"

namespace tia::test {
namespace {

/// Refused: a request, and the problem that it meets.
struct Refused {
  const char *method, *target, *body, *type;
  Headers headers = {};
};

const char* const long_picture =
    R"({"kind":"render","request":{"integrator":"path","samples":60000,"width":640}})";

TEST(JobProblems, AreThoseOfTheDocument) {
  Config config;
  config.max_jobs = 2;
  Host own(config);
  const std::string failed = job_id(
      own,
      R"({"kind":"render","max_rays":6000,"request":{"scene":"whitted","width":32,"height":24}})");
  EXPECT_EQ(ended(own, failed), "failed");
  const std::string running = job_id(own, long_picture), cancelled = job_id(own, long_picture);
  own.ask("DELETE", "/jobs/" + cancelled);
  const std::string kept = job_id(own, long_picture);  // as many as may be
  const char* const small = R"({"kind":"render","request":{"width":8,"height":8}})";
  const std::vector<Refused> all{
      {"POST", "/jobs", "{", "malformed"},
      {"POST", "/jobs", R"({"kind":"film"})", "unknown-name"},
      {"POST", "/jobs", R"({"kind":7})", "wrong-type"},
      {"POST", "/jobs", R"({"kind":"render"})", "missing"},
      {"POST", "/jobs?a=b", small, "conflict"},
      {"POST", "/jobs", R"({"kind":"render","request":{"width":0}})", "out-of-range"},
      {"POST", "/jobs", R"({"kind":"render","max_rays":9,"request":{}})", "limit"},
      {"POST", "/jobs", "plain words", "media-type"},
      {"POST", "/jobs", small, "not-acceptable", {{"Accept", "image/png"}}},
      {"POST", "/jobs", small, "out-of-range", {{"Idempotency-Key", "a b"}}},
      {"POST", "/jobs", small, "busy"},
      {"POST", "/render", R"({"key":"a"})", "busy", {{"Prefer", "respond-async"}}},
      {"PUT", "/jobs", "", "method"},
      {"GET", "/jobs", "", "unauthorized"},
      {"GET", "/jobs/load", "", "not-acceptable", {{"Accept", "image/png"}}},
      {"GET", "/jobs/ID", "", "out-of-range", {{"Prefer", "wait=61"}}},
      {"GET", "/jobs/ID", "", "not-acceptable", {{"Accept", "image/png"}}},
      {"GET", "/jobs/nobody", "", "not-found"},
      {"DELETE", "/jobs/nobody", "", "not-found"},
      {"GET", "/jobs/nobody/events", "", "not-found"},
      {"GET", "/jobs/nobody/parts", "", "not-found"},
      {"GET", "/jobs/nobody/result", "", "not-found"},
      {"GET", "/jobs/nobody/results/0", "", "not-found"},
      {"GET", "/jobs/ID/parts?state=begun", "", "unknown-name"},
      {"GET", "/jobs/ID/parts?first=-1", "", "out-of-range"},
      {"GET", "/jobs/ID/parts?frist=1", "", "unknown-name"},
      {"GET", "/jobs/ID/result?format=tar", "", "unknown-name"},
      {"GET", "/jobs/ID/result", "", "not-ready"},
      {"GET", "/jobs/ID/results/0", "", "not-ready"},
      {"GET", "/jobs/ID/results/1", "", "not-found"},
      {"GET", "/jobs/CANCELLED/result", "", "gone"},
      {"GET", "/jobs/CANCELLED/results/0", "", "gone"},
      {"GET", "/jobs/FAILED/result", "", "limit"},
      {"GET", "/jobs/FAILED/results/0", "", "limit"},
  };
  for (const Refused& each : all) {
    std::string target = each.target;
    for (const auto& [name, id] : {std::pair<std::string, std::string>{"CANCELLED", cancelled},
                                   {"FAILED", failed},
                                   {"ID", running}})
      if (const auto at = target.find(name); at != target.npos) target.replace(at, name.size(), id);
    Headers headers = each.headers;
    if (each.body[0] == '{') headers.emplace_back("Content-Type", "application/json");
    const Response refused = own.ask(each.method, target, each.body, headers);
    EXPECT_EQ(problem_of(refused).type, std::string("/problems/") + each.type)
        << each.method << ' ' << target << '\n'
        << refused.body;
  }
  for (const std::string& id : {running, kept})
    EXPECT_EQ(own.ask("DELETE", "/jobs/" + id).status, 204);
  // Nothing is asked for that anybody would have to know beforehand.
  EXPECT_EQ(own.ask("DELETE", "/jobs/" + kept + "?a=b").status, 204);
}

TEST(JobProblems, OfAStoreWithoutRoomAreTold) {
  Config config;
  config.max_jobs_bytes = 1;
  Host own(config);
  EXPECT_EQ(own.post("/jobs", R"({"kind":"render","request":{}})").problem, "storage-full");
}

}  // namespace
}  // namespace tia::test
