// What a service remembers of the scenes that it has drawn, when it keeps none of their pictures:
// little, however long they were.
#include "tests/memory/scarce_memory.h"
#include "tests/server/support.h"

namespace tia::test {
namespace {

std::string of_many_lights(int turn) {
  std::string lights;
  for (int i = 0; i < 2000; ++i)
    lights += R"(,{"type":"point","position":[0,0,0],"intensity":)" + std::to_string(i + 1) + "}";
  return R"({"width":1,"height":1,"scene":{"objects":[{"type":"sphere","center":[0,0,-9],"radius":)" +
         std::to_string(turn) + R"(}],"lights":[)" + lights.substr(1) + "]}}";
}

TEST(LearningMemory, OfAScenesCostIsNoLongerForMoreLights) {
  Config config;
  config.cache_bytes = config.max_geometry_bytes = 0;
  Host host(config);
  const auto draw = [&](int turn) {
    EXPECT_EQ(host.post("/render", of_many_lights(turn)).status, 200);
  };
  draw(1);
  const long before = live_bytes();
  constexpr int scenes = 50;
  for (int i = 2; i < 2 + scenes; ++i) draw(i);
  EXPECT_LE(live_bytes() - before, scenes * 1024L);
}

}  // namespace
}  // namespace tia::test
