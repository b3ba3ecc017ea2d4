// What keys decide of jobs: how many, how much they keep, how soon; whose they are; what is for
// admin alone.
#include "tests/server/access/access_support.h"
#include "tests/server/jobs/jobs_support.h"

namespace tia::test {
namespace {

using testing::HasSubstr;

const std::string jobs_right = R"("jobs","render","metrics")";
const std::string long_job =
    R"({"kind":"render","priority":"high","request":{"integrator":"path","samples":60000,"width":640}})";

Response ask_as(Host& host, const std::string& id, const std::string& method,
                const std::string& target, const std::string& body = "") {
  Request request = asking_as(id, target, method);
  request.body = body;
  if (!body.empty()) request.headers.emplace_back("Content-Type", "application/json");
  return ask_through(host, request);
}
std::string submitted_by(Host& host, const std::string& id, const std::string& job) {
  return "/jobs/" + job_id(ask_as(host, id, "POST", "/jobs", job));
}
Value status_of(Host& host, const std::string& id, const std::string& job) {
  return parse_json(ask_as(host, id, "GET", job).body);
}
std::string end_of(Host& host, const std::string& id, const std::string& job) {
  std::string state;
  EXPECT_TRUE(eventually([&] {
    state = text_at(status_of(host, id, job), "state");
    return state != "queued" && state != "running";
  }));
  return state;
}

TEST(KeysJobs, AreAsManyAsTheyMayBeAndNoSoonerThanTheirPriority) {
  const KeyFiles files(entry_of("few", R"("jobs":1,"priority":"low")", jobs_right) + "," +
                       entry_of("soon", R"("priority":"high")", jobs_right) + "," +
                       entry_of("anonymous", R"("jobs":0)", jobs_right));
  Host host(files.config);
  const std::string first = submitted_by(host, "few", long_job);
  EXPECT_EQ(text_at(status_of(host, "few", first), "priority"), "low");
  const Response refused = ask_as(host, "few", "POST", "/jobs", long_job);
  EXPECT_EQ(refused.status, 429);
  EXPECT_EQ(problem_of(refused).type, "/problems/quota");
  EXPECT_THAT(problem_of(refused).detail, HasSubstr("got 2 unfinished jobs, allowed: 1 (jobs of"));
  EXPECT_EQ(ask_as(host, "", "POST", "/jobs", long_job).status, 429);
  const std::string other = submitted_by(host, "soon", long_job);
  EXPECT_EQ(text_at(status_of(host, "soon", other), "priority"), "high");
  EXPECT_EQ(ask_as(host, "soon", "DELETE", other).status, 204);
  EXPECT_EQ(ask_as(host, "few", "DELETE", first).status, 204);
  const std::string again = submitted_by(host, "few", long_job);
  EXPECT_EQ(ask_as(host, "few", "DELETE", again).status, 204);
  const auto series = series_of(ask_as(host, "soon", "GET", "/metrics").body);
  EXPECT_EQ(series.at(R"(tia_keys_refused_total{why="jobs"})"), 2);
  EXPECT_EQ(series.at(R"(tia_key_refusals_total{key="few"})"), 1);
}

TEST(KeysJobs, KeepNoMoreBytesThanTheyMay) {
  const KeyFiles files(entry_of("a", R"("kept_bytes":10000)", jobs_right));
  Host host(files.config);
  const Response refused = ask_as(host, "a", "POST", "/jobs",
                                  R"({"kind":"render","request":{"width":200,"height":200}})");
  EXPECT_EQ(refused.status, 429);
  EXPECT_THAT(problem_of(refused).detail, HasSubstr("allowed: 10000 (kept_bytes of the key"));
  // What it comes to is known only once it is drawn: a batch of what noise cannot press.
  const std::string job = submitted_by(
      host, "a",
      R"({"kind":"batch","request":{"width":40,"height":40,"samples":1,"scene":"cornell"},
          "grid":{"/seed":[1,2,3,4,5,6]}})");
  EXPECT_EQ(end_of(host, "a", job), "failed");
  const Response result = ask_as(host, "a", "GET", job + "/result");
  EXPECT_EQ(result.status, 429);
  EXPECT_THAT(result.body, HasSubstr("kept_bytes"));
  EXPECT_EQ(ask_as(host, "a", "DELETE", job).status, 204);
  submitted_by(host, "a", R"({"kind":"render","request":{"width":8,"height":8}})");
}

// Whose ids nobody else could know.
TEST(KeysJobs, AreTheirKeysAndAdmins) {
  const KeyFiles files(entry_of("a", "", jobs_right) + "," + entry_of("b", "", jobs_right) + "," +
                       entry_of("chief", "", R"("admin","jobs")") + "," +
                       entry_of("anonymous", "", jobs_right));
  Host host(files.config);
  const std::string own = submitted_by(host, "a", long_job),
                    nobodys = submitted_by(host, "", long_job);
  for (const char* way : {"", "/events", "/result", "/results/0", "/parts"})
    for (const char* id : {"b", ""}) {
      const Response refused = ask_as(host, id, "GET", own + way);
      EXPECT_EQ(refused.status, 403) << way;
      EXPECT_EQ(problem_of(refused).type, "/problems/forbidden");
    }
  EXPECT_EQ(ask_as(host, "b", "DELETE", own).status, 403);
  EXPECT_EQ(ask_as(host, "b", "GET", nobodys).status, 200) << "for all who know of it";
  for (const char* id : {"a", "b", ""}) EXPECT_NE(ask_as(host, id, "GET", "/jobs").status, 200);
  const Value all = at(parse_json(ask_as(host, "chief", "GET", "/jobs").body), "jobs");
  ASSERT_EQ(all.as<Value::Array>()->size(), 2U);
  for (const Value& each : *all.as<Value::Array>())
    EXPECT_EQ("/jobs/" + text_at(at(each, "job"), "id") == own, text_at(each, "owner") == "key a");
  EXPECT_EQ(ask_as(host, "chief", "GET", "/jobs?first=2").body, R"({"jobs":[]})");
  EXPECT_EQ(ask_as(host, "chief", "GET", own).status, 200);
  for (const std::string& each : {own, nobodys})
    EXPECT_EQ(ask_as(host, "chief", "DELETE", each).status, 204);
  EXPECT_EQ(text_at(status_of(host, "a", own), "state"), "cancelled");
}

TEST(KeysJobs, PayExactlyForTheRaysOfWhatIsDrawnAndAreCounted) {
  const KeyFiles files(entry_of("a", R"("rays_per_day":1000000000)", jobs_right));
  Host host(files.config);
  host.service().jobs.cut_to(16);
  const std::string asked =
      R"({"kind":"render","request":{"key":"a","width":40,"height":28,"samples":3}})";
  const std::string job = submitted_by(host, "a", asked), same = submitted_by(host, "a", asked);
  EXPECT_EQ(end_of(host, "a", job), "done");
  EXPECT_EQ(end_of(host, "a", same), "done");
  const auto rays = [&](const std::string& of) {
    return number_at(at(status_of(host, "a", of), "progress"), "rays");
  };
  std::map<std::string, double> series;  // a part is counted just after its job has ended
  EXPECT_TRUE(eventually([&] {
    series = series_of(ask_as(host, "a", "GET", "/metrics").body);
    return series.at(R"(tia_job_parts_total{result="joined"})") == 2;
  }));
  EXPECT_EQ(series.at(R"(tia_key_rays_total{key="a"})"), rays(job) + rays(same));
  EXPECT_EQ(series.at(R"(tia_jobs{state="done"})"), 2);
  EXPECT_EQ(series.at(R"(tia_job_parts_total{result="done"})"), 12);
  EXPECT_EQ(series.at("tia_job_part_seconds_count"), 12);
  const Response last = ask_as(host, "a", "GET", job);
  EXPECT_THAT(*header(last, "RateLimit"),
              testing::StartsWith("\"rays\";r=" +
                                  std::to_string(std::int64_t(1e9 - rays(job) - rays(same)))));
}

TEST(Models, AreTakenAwayByAdminAlone) {
  const KeyFiles files(entry_of("a", "", R"("models")") + "," +
                       entry_of("chief", "", R"("admin","models")"));
  for (const bool on_disk : {false, true}) {
    const Folder folder;
    Config config = files.config;
    DataFiles data;
    if (on_disk) data.models = std::make_unique<ModelFolder>(folder.file(""), 1 << 20);
    const Gallery gallery;
    Backend backend(config, gallery, std::move(data), tia_program());
    const auto ask = [&](const std::string& id, const std::string& method,
                         const std::string& target, const std::string& body = "") {
      Request request = asking_as(id, target, method);
      request.body = body;
      backend.service.access.identify(request);
      return answer(request, backend.service);
    };
    const std::string model = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    const std::string target = "/models/" + sha256_hex(model);
    EXPECT_EQ(ask("a", "POST", "/models", model).status, 201);
    EXPECT_EQ(ask("a", "DELETE", target).status, 403);
    EXPECT_EQ(ask("a", "GET", target).status, 200);
    EXPECT_EQ(ask("chief", "DELETE", target).status, 204);
    EXPECT_EQ(ask("chief", "DELETE", target).status, 404);
    EXPECT_EQ(ask("a", "GET", target).status, 404);
    EXPECT_EQ(ask("chief", "DELETE", "/models/chess").status, 404);
    EXPECT_EQ(ask("a", "POST", "/models", model).status, 201) << "as if it had never been";
  }
}

}  // namespace
}  // namespace tia::test
