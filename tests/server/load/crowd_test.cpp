// Someone who drags a light beside those who draw posters, whatever they call them.
#include <atomic>
#include <future>
#include <list>

#include "tests/server/socket_support.h"

namespace tia::test {
namespace {

// Never the same twice: that would be drawn once.
std::string new_seed() {
  static std::atomic<int> last = 0;
  return std::to_string(++last);
}

Response ask_for_poster(Host& host) {
  return host.get("/render?width=4096&height=4096&samples=16&seed=" + new_seed());
}

// Two million rays from the eye are what a light picture may have; its lamp takes 256 times more.
Response ask_for_poster_in_disguise(Host& host) {
  return host.post("/render",
                   R"({"seed": )" + new_seed() + R"(, "width": 1400, "height": 1400, "scene": {
      "objects": [{"type": "plane", "point": [0, -1, 0], "normal": [0, 1, 0]}],
      "lights": [{"type": "sphere", "position": [4, 6, -3], "radius": 1, "samples": 256}]}})");
}

/// Crowd: many who ask at once. They leave when it ends.
class Crowd {
 public:
  Crowd(Host& host, Response (*ask)(Host&), int count) : host_(host) {
    for (int i = 0; i < count; ++i)
      answers_.push_back(std::async(std::launch::async, [&host, ask] { return ask(host); }));
  }
  ~Crowd() { host_.stop(); }
  /// Answers that have come, which are taken.
  std::vector<Response> come() {
    std::vector<Response> come;
    std::erase_if(answers_, [&](auto& answer) {
      const bool is_there = answer.wait_for(seconds(0)) == std::future_status::ready;
      if (is_there) come.push_back(answer.get());
      return is_there;
    });
    return come;
  }

 private:
  Host& host_;
  std::list<std::future<Response>> answers_;
};

Config of(int renders, int queue) {
  Config config;
  config.renders = renders;
  config.queue = queue;
  config.deadline_ms = 3'600'000;  // none of them could not end in time
  return config;
}

TEST(Crowd, OfPostersInDisguiseKeepsNobodyWaiting) {
  Host host(of(2, 64));
  Crowd crowd(host, ask_for_poster_in_disguise, 2);
  const Admission& admission = host.service().admission;
  ASSERT_TRUE(eventually([&] { return admission.at_work() == 2; }));
  EXPECT_EQ(host.get("/render?width=32&height=24").status, 200);
  EXPECT_EQ(admission.at_work(), 2);
  EXPECT_TRUE(crowd.come().empty());
}

TEST(Crowd, OfPostersLeavesTheQueueToOthers) {
  Host host(of(2, 8));
  Crowd crowd(host, ask_for_poster, 6);  // one is drawn, two wait
  std::vector<Response> refused;
  ASSERT_TRUE(eventually([&] {
    for (Response& each : crowd.come()) refused.push_back(std::move(each));
    return refused.size() == 3;
  }));
  for (const Response& each : refused) {
    EXPECT_EQ(each.status, 429);
    EXPECT_TRUE(header(each, "Retry-After"));
  }
  EXPECT_EQ(host.get("/render?width=32&height=24").status, 200);
  EXPECT_EQ(host.get("/readyz").status, 200);
}

}  // namespace
}  // namespace tia::test
