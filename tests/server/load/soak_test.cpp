// The whole program after thousands of good and bad requests: what it holds, counts and opens.
#include <sys/resource.h>

#include <mutex>
#include <random>

#include "tests/server/http/request_corpus.h"
#include "tests/server/load/soak_support.h"

namespace tia::test {
namespace {

// ---- R15 ------------------------------------------------------------------------------------

// Those that ask for no picture of the usual size: how many are drawn at once is chance, and so is
// the memory that then stays with the process.
std::vector<GoodRequest> without_pictures() {
  std::vector<GoodRequest> good = good_requests();
  std::erase_if(good, [](const GoodRequest& each) { return each.body == "{}"; });
  return good;
}

// One of many kinds, good and bad, on a connection of its own.
void anything(int port, std::mt19937& random) {
  static const std::vector<GoodRequest> good = without_pictures();
  const auto& bad = bad_requests();
  const std::size_t kind = random() % 9;
  Wire wire(port);
  if (kind == 0) wire.send(bad[random() % bad.size()].bytes);
  else if (kind == 1) wire.send(good[random() % good.size()].bytes);
  else if (kind == 2) wire.get(small_picture);
  else if (kind == 8) wire.get(small_picture + ("&seed=" + std::to_string(random() % 10'000)));
  else if (kind == 3) wire.get("/render?width=0&key=" + std::to_string(random()));
  else if (kind == 4) wire.send(forms::sized(" 28", R"({"width":8,"height":"eight"})"));
  else if (kind == 5) wire.send("GET /he");
  else if (kind == 6) wire.get("/" + std::to_string(random()));
  else wire.get("/metrics");
  if (random() % 3 == 0) return;  // leaves without a word
  wire.finish();
  try {
    wire.rest();
  } catch (const std::runtime_error&) {
    ADD_FAILURE() << "kind " << kind << " is neither answered nor closed";
  }
}

void ask_mixture(const Tia& tia, int count, unsigned seed) {
  std::vector<std::jthread> clients;
  for (unsigned c = 0; c < 4; ++c)
    clients.emplace_back([&, c] {
      std::mt19937 random(seed * 4 + c);
      for (int i = 0; i < count / 4; ++i) anything(tia.port(), random);
    });
}

TEST(SoakMixture, LeavesMemoryDescriptorsAndThreadsAsTheyWere) {
  Tia tia({"--port", "0", "--cache-bytes", "1000000"});
  ask_mixture(tia, 1000, 0);  // until all buffers are warm, and the cache is full
  const auto rested = [&] { return tia.get("/healthz").status == 200; };
  ASSERT_TRUE(eventually(rested));
  ASSERT_TRUE(eventually([&] { return counters(tia)["tia_connections"] <= 1; }));
  const long memory = kilobytes(tia);
  const auto descriptors = entries(tia, "fd"), threads = entries(tia, "task");
  const std::size_t series = counters(tia).size();
  for (unsigned round = 1; round <= 4; ++round) {
    ask_mixture(tia, scaled(3000) / 4, round);
    RecordProperty("kilobytes_" + std::to_string(round), static_cast<int>(kilobytes(tia) - memory));
  }
  ASSERT_TRUE(eventually([&] { return counters(tia)["tia_connections"] <= 1; }));
  RecordProperty("kilobytes", static_cast<int>(kilobytes(tia) - memory));
  RecordProperty("series", static_cast<int>(counters(tia).size()));
  EXPECT_LE(kilobytes(tia) - memory, 2048 + sanitizers_kilobytes());
  EXPECT_TRUE(eventually([&] { return entries(tia, "fd") <= descriptors + 1; }));
  EXPECT_EQ(entries(tia, "task"), threads);
  EXPECT_LE(counters(tia).size(), 200U);
  EXPECT_LE(counters(tia).size(), series + 20);  // targets are not labels
}

// ---- counters -------------------------------------------------------------------------------

struct Kind {
  std::string request;
  std::string route;
};

TEST(SoakCounters, EqualTheClientsCountByRouteAndStatus) {
  const auto get = [](const std::string& target) {
    return "GET " + target + " HTTP/1.1\r\nHost: x\r\n\r\n";
  };
  const std::vector<Kind> kinds{
      {get("/healthz"), "/healthz"},
      {get("/render?width=8&height=8"), "/render"},
      {get("/render?width=0"), "/render"},
      {get("/explain?x=1&y=1"), "/explain"},
      {get("/scenes/thesis"), "/scenes/{}"},
      {get("/scenes/none"), "/scenes/{}"},
      {get("/nowhere"), "none"},
      {get("/style.css"), "/{}"},
      {get("/"), "/"},
      {forms::sized(" 20", R"({"width":8,"k":"a"})"
                           " "),
       "/render"},
      {"DELETE /render HTTP/1.1\r\nHost: x\r\n\r\n", "/render"},
  };
  Tia tia;
  std::map<std::string, double> expected;
  std::mutex mutex;
  std::vector<std::jthread> clients;
  for (std::size_t c = 0; c < 4; ++c)
    clients.emplace_back([&, c] {
      Connection connection(tia.port());
      for (int i = 0; i < scaled(500); ++i) {
        const Kind& kind = kinds[(c + static_cast<std::size_t>(i)) % kinds.size()];
        connection.send(kind.request);
        const int status = connection.receive().status;
        const std::lock_guard lock(mutex);
        ++expected["tia_requests_total{route=\"" + kind.route + "\",status=\"" +
                   std::to_string(status) + "\"}"];
      }
    });
  clients.clear();
  for (int i = 0; i < 20; ++i)  // what is no request is counted, too
    EXPECT_EQ(exchange(tia.port(), "GET\r\n\r\n").status, 400);
  expected["tia_requests_total{route=\"none\",status=\"400\"}"] += 20;
  std::map<std::string, double> told = counters(tia);
  std::erase_if(told,
                [](const auto& each) { return !each.first.starts_with("tia_requests_total"); });
  EXPECT_EQ(told, expected);
}

// ---- R21 ------------------------------------------------------------------------------------

// Opened files would need a descriptor: there is none left but those for connections. A server that
// opens one for a moment fails, and says so with a 500.
TEST(SoakFiles, NoneIsOpenedAfterTheStart) {
  Tia tia;
  const std::vector<std::string> targets{"/",
                                         "/style.css",
                                         "/main.js",
                                         "/scenes",
                                         "/scenes/knot",
                                         "/schema/scene.json",
                                         "/version",
                                         "/metrics",
                                         "/readyz",
                                         "/render?scene=textures&width=16&height=12",
                                         "/explain?x=1&y=1",
                                         "/../etc/passwd",
                                         "/%2e%2e/etc/passwd",
                                         "/nowhere"};
  Connection connection(tia.port());
  const auto ask = [&](const std::string& target) {
    connection.send("GET " + target + " HTTP/1.1\r\nHost: x\r\n\r\n");
    const Response response = connection.receive();
    return std::make_pair(response.status, response.body.size());
  };
  std::map<std::string, std::pair<int, std::size_t>> before;
  for (const std::string& target : targets) before[target] = ask(target);
  const rlim_t held = entries(tia, "fd") + (sanitized() ? 8 : 0);
  const rlimit none{held, held};
  ASSERT_EQ(::prlimit(tia.pid(), RLIMIT_NOFILE, &none, nullptr), 0);
  for (const std::string& target : targets) {
    const auto after = ask(target);
    EXPECT_EQ(after.first, before[target].first) << target;
    if (target == "/metrics") continue;
    EXPECT_EQ(after.second, before[target].second) << target;
  }
}

}  // namespace
}  // namespace tia::test
