// A farm of processes: none of its parts is lost, none is done twice, and all have the bytes that
// /render draws, whoever is killed or stopped meanwhile.
#include <httplib.h>
#include <signal.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>

#include "core/input/json.h"
#include "tests/server/faults/faults_support.h"
#include "tests/server/redis_support.h"
#include "tests/server/s3_support.h"
#include "tests/server/support.h"

namespace tia::test {
namespace {

// TIA_LONG_TESTS: as long as it takes to believe it.
int parts_of_a_job() { return std::getenv("TIA_LONG_TESTS") != nullptr ? 200 : 24; }

// Processes that are watched take minutes for what leases give seconds.
constexpr const char* too_slow = "watched processes are too slow for leases";

/// FarmProcesses: a Redis that syncs, one who serves, and workers.
class FarmProcesses : public testing::Test {
 protected:
  static constexpr int lease_ms = 1000;

  void SetUp() override {
    if (RedisServer::program().empty()) GTEST_SKIP() << "redis-server is not installed";
    redis = std::make_unique<RedisServer>(true);
    serve = std::make_unique<Tia>(Process::Words{"--port", "0"}, variables());
  }
  Process::Words variables() const {
    return {"TIA_FARM=" + redis->url(), "TIA_FARM_LEASE_MS=" + std::to_string(lease_ms),
            "TIA_FARM_AUDIT=0", "TIA_HOSTS=*", "TIA_THREADS=1"};
  }
  std::unique_ptr<Tia> worker(const std::string& name, Process::Words more = {}) const {
    Process::Words environment = variables();
    environment.insert(environment.end(), more.begin(), more.end());
    return std::make_unique<Tia>(Process::Words{"worker", "--port", "0", "--name", name},
                                 environment);
  }
  // Of pictures whose seeds count up.
  std::string submit(int parts) const {
    std::string seeds;
    for (int i = 0; i < parts; ++i) seeds += (i > 0 ? "," : "") + std::to_string(i);
    const auto answer = serve->client().Post(
        "/jobs",
        R"({"kind":"batch","request":{"scene":"cornell","width":64,"height":64,"samples":4},)"
        R"("grid":{"/seed":[)" +
            seeds + "]}}",
        "application/json");
    if (!answer || answer->status != 202)
      throw std::runtime_error(answer ? answer->body : "no answer");
    return answer->get_header_value("Location");
  }
  /// While Redis is away: nothing.
  std::optional<Value> status(const std::string& job) const {
    const Response response = serve->get(job);
    return response.status == 200 ? std::optional(parse_json(response.body)) : std::nullopt;
  }
  std::string state(const std::string& job) const {
    const auto now = status(job);
    return now ? text_at(*now, "state") : "";
  }
  int done(const std::string& job) const {
    const auto now = status(job);
    return now ? static_cast<int>(number_at(at(*now, "progress"), "done")) : 0;
  }
  bool ends(const std::string& job, Clock::duration within = seconds(60)) const {
    return eventually([&] { return state(job) == "done"; }, within);
  }
  void expect_all_right(const std::string& job, int parts) const {
    EXPECT_EQ(done(job), parts);
    for (int n = 0; n < parts; n += 1 + parts / 4) {
      const Response drawn = serve->get(job + "/results/" + std::to_string(n));
      const Response same = serve->get("/render?scene=cornell&width=64&height=64&samples=4&seed=" +
                                       std::to_string(n));
      ASSERT_EQ(drawn.status, 200) << drawn.body;
      EXPECT_TRUE(drawn.body == same.body) << n;
      EXPECT_EQ(header(drawn, "ETag"), header(same, "ETag"));
    }
  }
  std::unique_ptr<RedisServer> redis;
  std::unique_ptr<Tia> serve;
};

TEST_F(FarmProcesses, AWorkerThatIsKilledLosesNothing) {
  if (sanitized()) GTEST_SKIP() << too_slow;
  auto first = worker("first");
  const auto second = worker("second");
  const int parts = parts_of_a_job();
  const std::string job = submit(parts);
  ASSERT_TRUE(eventually([&] { return done(job) > parts / 4; }));
  first->signal(SIGKILL);
  EXPECT_TRUE(ends(job));
  expect_all_right(job, parts);
}

TEST_F(FarmProcesses, ARedisThatIsKilledLosesNothing) {
  if (sanitized()) GTEST_SKIP() << too_slow;
  const auto first = worker("first"), second = worker("second");
  const int parts = parts_of_a_job();
  const std::string job = submit(parts);
  for (int i = 1; i <= 3; ++i) {
    ASSERT_TRUE(eventually([&] { return done(job) > i * parts / 5; }));
    redis->kill();
    EXPECT_EQ(serve->get(job).status, 503);
    EXPECT_EQ(serve->get("/render?width=8&height=8&samples=1&seed=" + std::to_string(i)).status,
              200);
    EXPECT_EQ(serve->get("/metrics").status, 200);
    EXPECT_TRUE(eventually([&] { return first->get("/readyz").status == 503; }));
    EXPECT_EQ(first->get("/healthz").status, 200);
    redis->start();
  }
  EXPECT_TRUE(ends(job));
  EXPECT_EQ(first->get("/readyz").status, 200);
  expect_all_right(job, parts);
}

TEST_F(FarmProcesses, AWorkerThatStopsBeyondItsLeaseDoesNothingTwice) {
  if (sanitized()) GTEST_SKIP() << too_slow;
  const auto first = worker("first"), second = worker("second");
  const int parts = parts_of_a_job();
  const std::string job = submit(parts);
  ASSERT_TRUE(eventually([&] { return done(job) > 2; }));
  first->signal(SIGSTOP);
  EXPECT_TRUE(ends(job)) << "the other one draws its part, too";
  first->signal(SIGCONT);
  const std::string next = submit(4);
  EXPECT_TRUE(ends(next));
  expect_all_right(job, parts);
  EXPECT_THAT(serve->get("/metrics").body, testing::HasSubstr("tia_farm_mismatches_total 0"));
}

TEST_F(FarmProcesses, AWorkerThatIsToldToEndGivesBackWhatItIsAt) {
  const auto first = worker("first", {"TIA_DRAIN_MS=0"});
  const auto answer = serve->client().Post(
      "/jobs",
      R"({"kind":"batch","requests":[{"scene":"cornell","width":640,"height":480,"samples":4096}]})",
      "application/json");
  ASSERT_TRUE(answer);
  const std::string job = answer->get_header_value("Location");
  ASSERT_TRUE(eventually([&] { return state(job) == "running"; }));
  first->signal(SIGTERM);
  EXPECT_EQ(first->wait().status, 0);
  const Value parts = parse_json(serve->get(job + "/parts").body);
  const Value& part = at(parts, "parts").as<Value::Array>()->front();
  EXPECT_EQ(text_at(part, "state"), "waiting");
  EXPECT_EQ(number_at(part, "tries"), 0);
  EXPECT_EQ(serve->client().Delete(job.c_str())->status, 204);
}

// Workers have nothing but the gallery: what a client has sent comes with the job.
TEST_F(FarmProcesses, AnyWorkerDrawsAModelThatAClientHasSentAndS3KeepsWhatComesOfIt) {
  if (sanitized()) GTEST_SKIP() << too_slow;
  S3StandIn s3;
  std::ofstream(redis->file("s3-key")) << s3.key_file();
  const Process::Words more{"TIA_STORE=s3://tia-test/farm", "TIA_S3_ENDPOINT=" + s3.endpoint(),
                            "TIA_S3_REGION=" + s3.options().region,
                            "TIA_S3_KEY_FILE=" + redis->file("s3-key")};
  Process::Words environment = variables();
  environment.insert(environment.end(), more.begin(), more.end());
  serve = std::make_unique<Tia>(Process::Words{"--port", "0"}, environment);
  const auto first = worker("first", more);
  const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  const auto sent = serve->client().Post("/models", triangle, "application/octet-stream");
  ASSERT_EQ(sent->status, 201) << sent->body;
  const std::string picture =
      R"({"width":32,"height":24,"scene":{"camera":{"location":[0,0,3]},)"
      R"("lights":[{"type":"point","position":[1,2,4]}],"objects":[{"type":"model","id":")" +
      text_at(parse_json(sent->body), "id") + "\"}]}}";
  const auto kept =
      serve->client().Post("/scenes", R"({"title":"kept","objects":[]})", "application/json");
  ASSERT_EQ(kept->status, 201) << kept->body;
  const std::string by_id =
      R"({"width":16,"height":16,"scene":")" + kept->get_header_value("Location").substr(8) + "\"}";
  s3.fail("GET", S3StandIn::Fault::flips_a_bit, 2);
  s3.fail("PUT", S3StandIn::Fault::answers_500, 2);
  const auto answer = serve->client().Post(
      "/jobs", R"({"kind":"batch","requests":[)" + picture + ',' + by_id + "]}",
      "application/json");
  ASSERT_EQ(answer->status, 202) << answer->body;
  const std::string job = answer->get_header_value("Location");
  ASSERT_TRUE(ends(job)) << serve->get(job).body << first->err();
  for (const auto& [n, same] : {std::pair("0", picture), std::pair("1", by_id)}) {
    const Response drawn = serve->get(job + "/results/" + n);
    EXPECT_EQ(drawn.status, 200) << drawn.body;
    EXPECT_EQ(drawn.body, serve->client().Post("/render", same, "application/json")->body) << n;
  }
  EXPECT_EQ(s3.kept().size(), 4U) << "two results, a model, a scene";
  EXPECT_EQ(s3.refused(), 0);
}

TEST_F(FarmProcesses, AStoreWhoseDiskIsFullForAWhileLosesNothing) {
  if (sanitized()) GTEST_SKIP() << too_slow;
  const Folder folder;
  const std::string below = std::filesystem::path(folder.file("x")).parent_path();
  Faults faults;
  faults.only_below(below);
  faults.begin({faults_write, ENOSPC}, 1, 2);
  Process::Words environment = variables();
  environment.push_back("TIA_STORE=dir:" + below);
  serve = std::make_unique<Tia>(Process::Words{"--port", "0"}, environment);
  Process::Words broken = faults.environment();
  broken.push_back("TIA_STORE=dir:" + below);
  const auto first = worker("first", broken);
  const std::string job = submit(3);
  EXPECT_TRUE(ends(job)) << first->err();
  EXPECT_EQ(faults.failed(), 2);
  expect_all_right(job, 3);
  EXPECT_EQ(serve->client().Delete(job.c_str())->status, 204);
  EXPECT_TRUE(eventually([&] { return std::filesystem::is_empty(below); }));
}

TEST_F(FarmProcesses, AWorkerAnswersWhetherItLivesAndTakesLittleWhenIdle) {
  const auto first = worker("first");
  for (const char* path : {"/healthz", "/readyz", "/metrics", "/version"})
    EXPECT_EQ(first->get(path).status, 200) << path;
  for (const char* path : {"/render", "/jobs/load"}) {  // as a server's document does not say
    const auto answer = first->client().Get(path);
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->status, 404) << path;
  }
  EXPECT_THAT(first->get("/metrics").body, testing::HasSubstr("tia_farm_up 1"));
  // Once it rests: what answers took is given back by and by.
  if (!sanitized()) EXPECT_TRUE(eventually([&] { return kilobytes(*first) < 20 * 1024; }));
}

TEST_F(FarmProcesses, WithoutItsRedisAServerDrawsAndTellsThatJobsAreAway) {
  const Tia alone({"--port", "0"}, {"TIA_FARM=redis://127.0.0.1:" + std::to_string(free_port())});
  EXPECT_EQ(alone.get("/render?width=8&height=8&samples=1").status, 200);
  const auto answer = alone.client().Post(
      "/jobs", R"({"kind":"render","request":{"width":8,"height":8}})", "application/json");
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->status, 503);
  EXPECT_THAT(answer->body, testing::HasSubstr("/problems/unavailable"));
  const std::string job = "/jobs/aaaaaaaaaaaaaaaaaaaaaaaaaa";
  for (const char* of : {"", "/events", "/result", "/results/0", "/parts"})
    EXPECT_THAT(alone.get(job + of).body, testing::HasSubstr("/problems/unavailable")) << of;
  EXPECT_THAT(alone.get("/jobs/load").body, testing::HasSubstr("/problems/unavailable"));
  EXPECT_EQ(alone.client().Delete(job.c_str())->status, 503);
  EXPECT_EQ(
      alone.client()
          .Post("/render", {{"Prefer", "respond-async"}}, R"({"key":"a"})", "application/json")
          ->status,
      503);
  EXPECT_THAT(alone.get("/metrics").body, testing::HasSubstr("tia_farm_up 0"));
}

TEST(FarmOptions, AreRefusedByName) {
  for (const auto& [words, named] : std::vector<std::pair<Process::Words, std::string>>{
           {{"worker"}, "TIA_FARM"},
           {{"worker", "--farm", "http://x"}, "TIA_FARM"},
           {{"worker", "--farm", "redis://x", "--name", "a b"}, "--name"},
           {{"serve", "--farm", "redis://x", "--farm-password-file", "/nowhere"},
            "TIA_FARM_PASSWORD_FILE"},
           {{"serve", "--store", "dir:/tmp"}, "TIA_DATA_DIR"},
           {{"serve", "--store", "dir:/nowhere", "--data-dir", "/tmp"}, "TIA_STORE"},
           {{"serve", "--farm", "redis://x", "--store", "dir:/nowhere"}, "TIA_STORE"},
           {{"serve", "--farm", "redis://x", "--store", "s3://bucket", "--s3-endpoint", "minio"},
            "TIA_S3_ENDPOINT"}}) {
    const Finished ended = run(words);
    EXPECT_EQ(ended.status, 2) << ended.err;
    EXPECT_THAT(ended.err, testing::HasSubstr(named));
  }
}

}  // namespace
}  // namespace tia::test
