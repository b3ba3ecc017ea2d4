// Of two clients each has half of the processors' time, whatever the other one asks for: work that
// cannot be shared among threads, or whose parts are long, gives way, too. Seconds; SOAK=10 makes
// them minutes.
#include <algorithm>
#include <cstdio>
#include <optional>

#include "tests/server/load/siege_support.h"
#include "tests/server/load/soak_support.h"

namespace tia::test {
namespace {

/// Hog: what a client asks for again and again, on eight connections; made for a server's port.
struct Hog {
  const char* law;
  std::function<std::function<void(Asker&)>(int port)> made;
};

std::string repeated(int count, const std::function<std::string(int)>& text) {
  std::string all;
  for (int i = 0; i < count; ++i) all += (i == 0 ? "" : ",") + text(i);
  return all;
}

// No scene, seed or width was there before.
std::string fresh() {
  static std::atomic<int> count = 0;
  return std::to_string(++count);
}

// Thirty surfaces that take a second to part into patches.
void build(Asker& asker) {
  const auto nested = [](const std::string& inner) {
    std::string text;
    for (int i = 0; i < 60; ++i) text += "sin(";
    return text + inner + std::string(60, ')');
  };
  const std::string objects = repeated(30, [&](int) {
    return R"({"type":"parametric","u":[0,6],"v":[0,6],"x":"u+)" + nested("99*u*v") +
           R"(","y":"v+)" + nested("98*u*v") + R"(","z":")" + nested("97*u*v+" + fresh()) + "\"}";
  });
  asker.ask("POST", "/render", R"({"width":8,"height":8,"scene":{"objects":[)" + objects + "]}}",
            milliseconds(1000));
}

// A picture of one tile, which takes seconds.
void draw_one_tile(Asker& asker) {
  asker.ask("GET", "/render?scene=soft-shadows&width=16&height=16&samples=4000&seed=" + fresh(), "",
            milliseconds(4000));
}

std::string scene_of_lights(int count) {
  const auto light = [](int i) {
    return R"({"type":"point","position":[)" + std::to_string(i) + R"(,9,9],"intensity":0.001})";
  };
  return R"({"title":")" + fresh() + R"(","lights":[)" + repeated(count, light) + "]}";
}

// What a kept scene's pictures are called: no ray is traced for that.
std::function<void(Asker&)> name_pictures_of_lights(int port) {
  Asker keeper(port, "10.0.0.3");
  EXPECT_EQ(keeper.ask("POST", "/scenes", scene_of_lights(24'000)), 201);
  const std::string id = keeper.body().substr(keeper.body().find("\"id\":\"") + 6, 64);
  return [id](Asker& asker) {
    asker.ask("HEAD", "/render?scene=" + id + "&width=8&height=8&seed=" + fresh());
  };
}

std::function<std::function<void(Asker&)>(int)> anywhere(std::function<void(Asker&)> act) {
  return [act](int) { return act; };
}

// Pictures a second of one who asks for the next as soon as he has one.
double rate(Asker& asker, Clock::duration time) {
  const auto start = Clock::now();
  int good = 0;
  while (Clock::now() - start < time)
    good +=
        asker.ask("GET", "/render?scene=soft-shadows&width=160&height=120&seed=" + fresh()) == 200;
  return good / std::chrono::duration<double>(Clock::now() - start).count();
}

class Halves : public testing::TestWithParam<Hog> {};

TEST_P(Halves, AreLeftToAnotherBeside) {
  if (sanitized()) GTEST_SKIP() << "its rates are another's";
  Tia tia({"--port", "0", "--trusted-proxies", "127.0.0.1"});
  const auto act = GetParam().made(tia.port());
  Asker other(tia.port(), "10.0.0.1");
  const double before = rate(other, milliseconds(scaled(1000)));
  const auto one_address = [&act, port = tia.port()](Asker&, int) {
    Asker hog(port, "10.0.0.2");
    act(hog);
  };
  std::optional<Siege> siege;
  siege.emplace(tia.port(), std::vector<Attack>(8, {GetParam().law, one_address}));
  std::this_thread::sleep_for(milliseconds(500));
  const double beside = rate(other, milliseconds(scaled(3000)));
  siege.reset();
  // Other tests come and go meanwhile: what it has alone is measured on both sides.
  const double alone = std::min(before, rate(other, milliseconds(scaled(1000))));
  std::printf("%s: %.1f pictures/s alone, %.1f beside eight of another's\n", GetParam().law, alone,
              beside);
  EXPECT_GT(beside, (scale() > 1 ? 0.4 : 0.25) * alone);  // the short form runs beside other tests
}
INSTANTIATE_TEST_SUITE_P(Who, Halves,
                         testing::Values(Hog{"Builds", anywhere(build)},
                                         Hog{"DrawsLongTiles", anywhere(draw_one_tile)},
                                         Hog{"AsksOfManyLights", name_pictures_of_lights},
                                         Hog{"KeepsScenes", anywhere([](Asker& asker) {
                                               static const std::string rest =
                                                   scene_of_lights(12'000).substr(1);
                                               asker.ask(
                                                   "POST", "/scenes",
                                                   R"({"description":")" + fresh() + "\"," + rest);
                                             })}),
                         [](const auto& of) { return of.param.law; });

}  // namespace
}  // namespace tia::test
