// What who watches a job is told, over sockets and without workers; and jobs of a process that is
// killed.
#include <httplib.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <random>

#include "tests/server/http/wire.h"
#include "tests/server/jobs/jobs_support.h"
#include "tests/server/process_support.h"

namespace tia::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const std::string long_job =
    R"({"kind":"render","request":{"integrator":"path","samples":60000,"width":640}})";

std::string get_request(const std::string& target, const std::string& more = "",
                        const char* version = "1.1") {
  return "GET " + target + " HTTP/" + version + "\r\nHost: x\r\n" + more + "\r\n";
}
// The ids of events, in their order.
std::vector<int> ids_in(const std::string& body) {
  std::vector<int> ids;
  for (std::size_t at = body.find("id: "); at != body.npos; at = body.find("\nid: ", at + 1))
    ids.push_back(std::stoi(body.substr(body.find(' ', at))));
  return ids;
}

TEST(JobEvents, RiseByOneUntilTheLastStateAndGoOnAfterTheLastOneThatCame) {
  Server server;
  server.host().service().jobs.cut_to(16);
  const std::string id =
      job_id(server.host(), R"({"kind":"render","request":{"width":64,"height":48,"samples":4}})");
  const std::string target = "/jobs/" + id + "/events";
  const Response all = exchange(server.port(), get_request(target));
  EXPECT_EQ(all.status, 200);
  EXPECT_EQ(all.content_type, "text/event-stream");
  const std::vector<int> ids = ids_in(all.body);
  ASSERT_GT(ids.size(), 12U);
  for (std::size_t i = 0; i < ids.size(); ++i) EXPECT_EQ(ids[i], static_cast<int>(i) + 1);
  EXPECT_THAT(all.body, HasSubstr("event: part\ndata: {\"n\":"));
  EXPECT_THAT(all.body, HasSubstr("\"window\":[48,32,64,48]"));
  EXPECT_THAT(all.body, HasSubstr("event: progress\n"));
  EXPECT_THAT(all.body, testing::EndsWith("event: state\ndata: {\"state\":\"done\"}\n\n"));
  const Response rest = exchange(server.port(), get_request(target, "Last-Event-ID: 10\r\n"));
  EXPECT_EQ(ids_in(rest.body).front(), 11);
  const std::string last = "Last-Event-ID: " + std::to_string(ids.back()) + "\r\n";
  EXPECT_EQ(exchange(server.port(), get_request(target, last)).status, 204);
}

TEST(JobEvents, GoUntilTheConnectionsEndInHttp10) {
  Server server;
  const std::string id =
      job_id(server.host(), R"({"kind":"render","request":{"width":8,"height":8}})");
  Wire wire(server.port());
  wire.send(get_request("/jobs/" + id + "/events", "", "1.0"));
  std::string all;
  for (std::string more = wire.read(4096); !more.empty(); more = wire.read(4096)) all += more;
  EXPECT_THAT(all, Not(HasSubstr("chunked")));
  EXPECT_THAT(all, HasSubstr("\r\n\r\nid: 1\nevent: state\n"));
  EXPECT_THAT(all, testing::EndsWith("data: {\"state\":\"done\"}\n\n"));
}

TEST(JobStatus, WaitsForAChangeWithoutAWorker) {
  HttpOptions options = any_port();
  options.workers = 2;
  Server server(options);
  const std::string id = job_id(server.host(), long_job);
  ASSERT_TRUE(eventually([&] { return state_of(server.host(), id) == "running"; }));
  std::vector<std::unique_ptr<Wire>> waiting;
  for (int i = 0; i < 8; ++i) {
    waiting.push_back(std::make_unique<Wire>(server.port()));
    waiting.back()->send(get_request("/jobs/" + id, "Prefer: wait=60\r\n"));
    EXPECT_THAT(waiting.back()->until("\r\n\r\n"), HasSubstr("wait=60"));
  }
  EXPECT_EQ(server.host().ask("DELETE", "/jobs/" + id).status, 204);
  for (auto& each : waiting) EXPECT_THAT(each->until("0\r\n\r\n"), HasSubstr("cancelled"));
}

TEST(JobEvents, OfManyCostNoWorkerAndLeaveNothing) {
  const int many = sanitized() ? 52 : 500;
  HttpOptions options = any_port();
  options.workers = 4;
  Server server(options);
  const std::string id = job_id(server.host(), long_job);
  std::vector<std::unique_ptr<Wire>> watching;
  for (int i = 0; i < many; ++i) {
    watching.push_back(std::make_unique<Wire>(server.port()));
    watching.back()->send(get_request("/jobs/" + id + "/events"));
    if (i % options.workers != options.workers - 1) continue;
    for (int last = options.workers; last > 0; --last)
      EXPECT_THAT(watching[watching.size() - std::size_t(last)]->until("queued"),
                  StartsWith("HTTP/1.1 200"));
  }
  EXPECT_EQ(server.host().service().jobs.board().feeds(), many);
  EXPECT_EQ(exchange(server.port(), get_request("/healthz")).status, 200);
  server.host().ask("DELETE", "/jobs/" + id);
  for (auto& each : watching) EXPECT_THAT(each->until("0\r\n\r\n"), HasSubstr("cancelled"));
  watching.clear();
  EXPECT_TRUE(eventually([&] { return server.host().service().jobs.board().feeds() == 0; }));
}

// What all but five of a hundred requests take. Unit: ms.
double usual_most_ms(httplib::Client& client) {
  std::vector<double> took;
  for (int i = 0; i < 100; ++i) {
    const auto start = Clock::now();
    EXPECT_EQ(client.Get("/healthz")->status, 200);
    took.push_back(ms_since(start));
  }
  std::ranges::nth_element(took, took.begin() + 94);
  return took[94];
}

// Of a process of its own, whose memory is told. On a busy machine all takes longer.
TEST(JobEvents, OfFiveHundredTakeLittleMemoryAndDelayNobody) {
  if (sanitized()) GTEST_SKIP() << "memory and times are another's";
  constexpr int many = 500;
  const Tia tia;
  auto client = tia.client();
  const auto accepted = client.Post("/jobs", long_job, "application/json");
  ASSERT_TRUE(accepted && accepted->status == 202);
  const std::string job = accepted->get_header_value("Location");
  const double alone = usual_most_ms(client);
  const long before = kilobytes(tia);
  std::vector<std::unique_ptr<Wire>> watching;
  for (int i = 0; i < many; ++i) {
    watching.push_back(std::make_unique<Wire>(tia.port()));
    watching.back()->send(get_request(job + "/events"));
    EXPECT_THAT(watching.back()->until("queued"), StartsWith("HTTP/1.1 200"));
  }
  EXPECT_LE(kilobytes(tia) - before, 16 * many);
  EXPECT_TRUE(eventually([&] { return usual_most_ms(client) <= std::max(5.0, 2 * alone); }));
  client.Delete(job.c_str());
}

TEST(JobEvents, OfWhoDoesNotReadEndAndGoOnWhenItComesAgain) {
  if (std::getenv("TIA_LONG_TESTS") == nullptr) GTEST_SKIP() << "it waits for ten seconds";
  Server server;
  server.host().service().jobs.cut_to(16);
  const std::string id =
      job_id(server.host(), R"({"kind":"render","request":{"width":640,"height":480}})");
  const std::string target = "/jobs/" + id + "/events";
  Wire wire(server.port(), 4096);
  wire.send(get_request(target));
  const Board& board = server.host().service().jobs.board();
  ASSERT_TRUE(eventually([&] { return board.feeds() == 1; }));
  EXPECT_TRUE(eventually([&] { return board.feeds() == 0; }, seconds(60)));
  const std::vector<int> ids = ids_in(wire.rest());
  ASSERT_FALSE(ids.empty());
  EXPECT_LT(ids.size(), 1000U) << "what it did not read was not sent";
  const Response rest = exchange(
      server.port(), get_request(target, "Last-Event-ID: " + std::to_string(ids.back()) + "\r\n"));
  EXPECT_THAT(rest.body, testing::EndsWith("event: state\ndata: {\"state\":\"done\"}\n\n"));
}

TEST(JobEvents, EndWhenTheServerGoesDown) {
  auto server = std::make_unique<Server>();
  const std::string id = job_id(server->host(), long_job);
  Wire wire(server->port());
  wire.send(get_request("/jobs/" + id + "/events"));
  wire.until("queued");
  const auto start = Clock::now();
  server.reset();
  EXPECT_LT(ms_since(start), 5000);
}

TEST(Residue, OfJobsThatAreLetGoIsNothing) {
  const int many = sanitized() ? 5 : 20;
  const Folder folder;
  const Tia tia({}, {"TIA_DATA_DIR=" + folder.file("")});
  auto client = tia.client();
  const auto round = [&] {
    for (int i = 0; i < many; ++i) {
      const auto accepted = client.Post(
          "/jobs", R"({"kind":"batch","requests":[{"width":8,"height":8},{"width":9}]})",
          "application/json");
      ASSERT_TRUE(accepted && accepted->status == 202);
      const std::string job = accepted->get_header_value("Location");
      if (i % 2 == 0) client.Get((job + "/events").c_str());  // to its end
      while (client.Delete(job.c_str())->status == 204) {
      }
    }
  };
  round();  // threads and descriptors that stay are there by then
  const auto threads = entries(tia, "task"), files = entries(tia, "fd");
  round();
  EXPECT_EQ(entries(tia, "task"), threads);
  EXPECT_TRUE(eventually([&] { return entries(tia, "fd") <= files; }));
  EXPECT_THAT(client.Get("/metrics")->body, HasSubstr("tia_jobs{state=\"done\"} 0"));
}

/// KilledServer: whether results are in a store.
class KilledServer : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(AndItsStore, KilledServer, testing::Bool());

// Each time what is done stays done, and what was under way is drawn again.
TEST_P(KilledServer, EndsItsJobAllTheSame) {
  const char* asked = std::getenv("TIA_KILLS");
  const int kills = asked != nullptr ? std::atoi(asked) : sanitized() ? 1 : 3;
  Folder folder, store;
  Process::Words environment{"TIA_DATA_DIR=" + folder.file(""), "TIA_JOB_TRIES=100"};
  if (GetParam()) environment.push_back("TIA_STORE=dir:" + store.file(""));
  std::string requests, id;
  for (int i = 0; i < 60; ++i)
    requests += (i > 0 ? "," : "") + std::string(R"({"width":64,"height":48,"samples":2,"seed":)") +
                std::to_string(i) + R"(,"scene":"cornell-light"})";
  const std::string job = R"({"kind":"batch","requests":[)" + requests + "]}";
  std::mt19937 random(7);
  double done = 0;
  for (int round = 0; round <= kills; ++round) {
    Tia tia({}, environment);
    auto client = tia.client();
    if (id.empty()) {
      const auto accepted = client.Post("/jobs", job, "application/json");
      ASSERT_TRUE(accepted && accepted->status == 202) << (accepted ? accepted->body : "");
      id = accepted->get_header_value("Location");
    }
    const Value progress = at(parse_json(tia.get(id).body), "progress");
    EXPECT_GE(number_at(progress, "done"), done);
    if (round == kills) {
      ASSERT_TRUE(eventually(
          [&] {
            const Value now = parse_json(tia.get(id).body);
            return text_at(now, "state") == "done" && at(now, "durable") == Value(true);
          },
          seconds(60)))
          << tia.get(id).body;
      const Response one = tia.get(id + "/results/59");
      EXPECT_TRUE(one.body == host()
                                  .post("/render",
                                        R"({"width":64,"height":48,"samples":2,"seed":59,)"
                                        R"("scene":"cornell-light"})")
                                  .body);
      const auto zip = tia.get(id + "/result?format=zip");
      EXPECT_THAT(zip.body, StartsWith("PK"));
      EXPECT_THAT(zip.body, HasSubstr("00059.png"));
      EXPECT_EQ(std::filesystem::is_empty(store.file("")), !GetParam());
      EXPECT_EQ(client.Delete(id.c_str())->status, 204);
      EXPECT_TRUE(eventually([&] { return std::filesystem::is_empty(store.file("")); }));
      break;
    }
    std::this_thread::sleep_for(milliseconds(100 + random() % 200));
    done = number_at(at(parse_json(tia.get(id).body), "progress"), "done");
    tia.signal(SIGKILL);
    tia.wait();
  }
}

}  // namespace
}  // namespace tia::test
