// What one client may do to others: those who want little, or nothing that is not there already, do
// not wait for those who want all. Seconds; SOAK=10 makes them minutes.
#include <httplib.h>
#include <sys/resource.h>

#include <cstdio>
#include <filesystem>

#include "tests/server/load/siege_support.h"
#include "tests/server/load/soak_support.h"

namespace tia::test {
namespace {

Process::Words behind_a_proxy(Process::Words options = {}) {
  Process::Words all{"--port", "0", "--trusted-proxies", "127.0.0.1"};
  all.insert(all.end(), options.begin(), options.end());
  return all;
}

std::string poster(int turn) {
  return "/render?width=4000&height=4000&samples=16&seed=" + std::to_string(turn);
}

// ---- cheap answers --------------------------------------------------------------------------

TEST(CheapAnswers, WaitForNothingHoweverFullTheQueue) {
  Tia tia(behind_a_proxy({"--renders", "1", "--queue", "4"}));
  const std::string picture = "/render?width=64&height=48&key=a";
  const std::string tag = *header(tia.get(picture), "ETag");
  std::atomic<int> posters = 0;
  const auto ask_for_one = [&](Asker& asker, int) {
    if (asker.ask("GET", poster(++posters)) == 429) std::this_thread::sleep_for(milliseconds(5));
  };
  Siege siege(tia.port(), std::vector<Attack>(8, {"Posters", ask_for_one}));
  Asker newcomer(tia.port(), "10.0.0.9");
  ASSERT_TRUE(eventually([&] {  // so full that a newcomer's poster is sent away
    return newcomer.ask("GET", poster(0), "", milliseconds(100)) == 429;
  }));
  auto client = tia.client();
  for (int i = 0; i < scaled(100); ++i) {
    const auto start = Clock::now();
    ASSERT_EQ(client.Get(picture.c_str())->status, 200);
    ASSERT_EQ(client.Get(picture.c_str(), {{"If-None-Match", tag}})->status, 304);
    ASSERT_EQ(client.Head(picture.c_str())->status, 200);
    for (const char* table : {"/healthz", "/scenes", "/scenes/thesis", "/metrics", "/"})
      ASSERT_EQ(client.Get(table)->status, 200);
    ASSERT_LT(ms_since(start), 2000);
  }
}

// ---- shares ---------------------------------------------------------------------------------

class Flood : public testing::TestWithParam<Attack> {};

// Sixteen of them, from one address.
TEST_P(Flood, DoesNotSlowDownWhoDrags) {
  if (sanitized()) GTEST_SKIP() << "its rates are another's";
  Tia tia(behind_a_proxy());
  Neighbour dragging(tia.port(), "10.0.0.1");
  const auto time = milliseconds(scaled(3000));
  const double alone = dragging.pictures_a_second(milliseconds(scaled(1000)));
  const auto one_address = [act = GetParam().act, port = tia.port()](Asker&, int turn) {
    Asker flooder(port, "10.0.0.2");
    act(flooder, turn);
  };
  Siege siege(tia.port(), std::vector<Attack>(16, {GetParam().law, one_address}));
  std::this_thread::sleep_for(milliseconds(500));
  const double beside = dragging.pictures_a_second(time);
  std::printf("%s: %.1f pictures/s alone, %.1f beside sixteen\n", GetParam().law, alone, beside);
  EXPECT_GT(beside, (scale() > 1 ? 0.8 : 0.5) * alone);  // the short form runs beside other tests
}
INSTANTIATE_TEST_SUITE_P(
    Of, Flood,
    testing::Values(
        Attack{"Leavers", [](Asker& asker,
                             int turn) { asker.ask("GET", poster(turn), "", milliseconds(30)); }},
        Attack{"Posters", [](Asker& asker, int turn) { asker.ask("GET", poster(turn)); }},
        Attack{"SmallOnes",
               [](Asker& asker, int turn) {
                 asker.ask("GET",
                           "/render?width=400&height=300&samples=4&seed=" + std::to_string(turn));
               }}),
    [](const auto& of) { return of.param.law; });

// What one client has begun and another waits for, too, does not wait for all else that the first
// one has begun before.
TEST(Joined, PicturesNeedNotWaitForTheirOwnersOlderOnes) {
  if (sanitized()) GTEST_SKIP() << "its rates are another's";
  Tia tia(behind_a_proxy());
  const auto heavy = [](int samples, int seed) {
    return "/render?scene=soft-shadows&width=160&height=120&samples=" + std::to_string(samples) +
           "&seed=" + std::to_string(seed);
  };
  const auto asked = [&](const char* address, const std::string& target, Clock::duration patience) {
    Asker asker(tia.port(), address);
    const auto start = Clock::now();
    const int status = asker.ask("GET", target, "", patience);
    return std::pair(status, ms_since(start));
  };
  const double alone = asked("10.0.0.9", heavy(64, 1), seconds(30)).second;
  std::vector<std::jthread> owner;  // its older one takes many times as long
  for (const int samples : {1024, 64})
    owner.emplace_back([&, samples] {
      std::this_thread::sleep_for(milliseconds(samples == 64 ? 800 : 0));
      asked("10.0.0.2", heavy(samples, 2), milliseconds(static_cast<int>(8 * alone)));
    });
  std::this_thread::sleep_for(milliseconds(800 + static_cast<int>(1.5 * alone)));
  const auto [status, took] = asked("10.0.0.3", heavy(64, 2), seconds(30));
  std::printf("%.0f ms alone, %.0f ms joined beside its owner's older one\n", alone, took);
  EXPECT_EQ(status, 200);
  EXPECT_LT(took, 4 * alone);
}

// ---- begun work -----------------------------------------------------------------------------

struct Load {
  std::atomic<int> good = 0, refused = 0, other = 0;
};

// So many clients, each asking again as soon as it is answered, for scenes that nobody knows and
// that are dearer than they look.
void drive(Load& load, int port, int clients, Clock::duration time) {
  static std::atomic<int> scenes = 0;
  const auto end = Clock::now() + time;
  std::vector<std::jthread> threads;
  for (int c = 0; c < clients; ++c)
    threads.emplace_back([&load, port, c, end] {
      Asker asker(port, "10.0.2." + std::to_string(c));
      while (Clock::now() < end) {
        const int status = asker.ask("POST", "/render",
                                     R"({"width":200,"height":150,"scene":{
          "objects":[{"type":"plane","point":[0,-1,)" +
                                         std::to_string(++scenes) +
                                         R"(],"normal":[0,1,0]}],
          "lights":[{"type":"sphere","position":[4,6,-3],"radius":1,"samples":256}]}})");
        ++(status == 200 ? load.good : status == 429 ? load.refused : load.other);
        if (status == 429) std::this_thread::sleep_for(milliseconds(50));
      }
    });
}

TEST(Overload, OfHiddenCostsThrowsNothingAwayThatHasBegun) {
  if (sanitized()) GTEST_SKIP() << "its rates are another's";
  Tia tia(behind_a_proxy({"--renders", "2", "--queue", "8", "--cache-bytes", "0"}));
  const auto time = milliseconds(scaled(4000));
  Load peak, over;
  drive(peak, tia.port(), 2, time);
  drive(over, tia.port(), 40, time);
  const double goodput = static_cast<double>(over.good) / peak.good;
  std::printf("%d pictures at the peak, %d under overload, %d refused\n", peak.good.load(),
              over.good.load(), over.refused.load());
  EXPECT_EQ(peak.other + over.other, 0);
  EXPECT_EQ(peak.refused, 0);
  EXPECT_GT(over.refused, 0);
  EXPECT_GE(goodput, scale() > 1 ? 0.9 : 0.6);
}

// ---- files ----------------------------------------------------------------------------------

TEST(FileLimit, EndsNoServer) {
  const Folder folder;
  Tia tia({"--port", "0", "--data-dir", folder.file("")});
  const rlimit small{1 << 19, 1 << 19};
  ASSERT_EQ(prlimit(tia.pid(), RLIMIT_FSIZE, &small, nullptr), 0);
  auto client = tia.client();
  int last = 201;
  for (int i = 0; i < 40 && last == 201; ++i)
    last =
        client
            .Post("/scenes", R"({"title":")" + std::to_string(i) + std::string(60'000, 'x') + "\"}",
                  "application/json")
            ->status;
  EXPECT_THAT(last, testing::AnyOf(503, 507));
  EXPECT_EQ(client.Get("/healthz")->status, 200);
  EXPECT_TRUE(tia.running());
}

}  // namespace
}  // namespace tia::test
