// All attacks that we know, and the largest of everything legal, at once, on a server with little
// memory: it lives, it answers who only asks a little, and it never asks the kernel for what it has
// not. Some seconds for each size; SOAK=10 makes them minutes.
#include "tests/server/load/siege_support.h"

#include <cstdio>

#include "tests/server/load/soak_support.h"

namespace tia::test {
namespace {

class UnderSiege : public testing::TestWithParam<int> {};

TEST_P(UnderSiege, TheServerLivesAndServesItsNeighbours) {
  if (sanitized()) GTEST_SKIP() << "it takes more addresses, and rates are another's";
  const std::int64_t bytes = std::int64_t{GetParam()} << 20;
  Tia tia({"--port", "0", "--trusted-proxies", "127.0.0.1"}, {}, -1, bytes);
  Neighbour dragging(tia.port(), "10.0.0.1"), looking(tia.port(), "10.0.0.2");
  const auto time = milliseconds(scaled(8000));
  const double alone = dragging.pictures_a_second(milliseconds(scaled(1000)));
  double beside = 0, health = 0;
  std::vector<int> turns;
  const std::vector<Attack> kinds = attacks();
  {
    Siege siege(tia.port(), kinds);
    std::this_thread::sleep_for(seconds(1));
    std::jthread drags([&] { beside = dragging.pictures_a_second(time); });
    health = looking.health_ms(time);
    drags.join();
    turns = siege.turns();
    ASSERT_TRUE(tia.running()) << tia.err();
  }
  std::printf(
      "%d MiB: %.1f pictures/s alone, %.1f under siege; /healthz %.2f ms; %ld MiB at most\n",
      GetParam(), alone, beside, health, kilobytes(tia, "VmHWM") / 1024);
  for (std::size_t i = 0; i < kinds.size(); ++i) std::printf("  %s %d\n", kinds[i].law, turns[i]);
  // The short form runs beside other tests.
  EXPECT_GT(beside, (scale() > 1 ? 0.8 : 0.5) * alone);
  EXPECT_LT(health, scale() > 1 ? 5 : 25);
  EXPECT_LE(kilobytes(tia, "VmHWM") * 1024, bytes);
  tia.signal(SIGTERM);
  const Finished end = tia.wait();
  EXPECT_EQ(end.status, 0);
  EXPECT_THAT(end.err, Not(testing::HasSubstr("out of memory")));
}
INSTANTIATE_TEST_SUITE_P(OfMebibytes, UnderSiege, testing::Values(512, 2048));

}  // namespace
}  // namespace tia::test
