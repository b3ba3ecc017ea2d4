// Stopping a render: between tiles, promptly, and without harm to the pool.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>

#include "tests/core/random_scene.h"

namespace tia {
namespace {

struct Subject {
  World world = compile(test::thesis_scene('a'));
  View view = view_of(Camera{}, 640, 480);
  Window all{0, 0, 640, 480};
};

RenderOptions threads(int count) {
  RenderOptions options;
  options.threads = count;
  return options;
}

TEST(Stop, FromInsideABlockNoThreadBeginsAnother) {
  const Subject subject;
  for (const int count : {1, 2, 5}) {
    Pool pool(count);
    std::stop_source source;
    std::atomic<int> developed = 0;
    EXPECT_THROW(
        render(subject.world, subject.view, subject.all, threads(count), pool, source.get_token(),
               [&](const FilmTile&) {
                 ++developed;
                 source.request_stop();
               }),
        Stopped);
    // Each thread may have been at one tile when the word came; there are 300.
    EXPECT_LE(developed, count);
    EXPECT_GE(developed, 1);
  }
}

TEST(Stop, BeforeTheStartNothingIsTraced) {
  const Subject subject;
  Pool pool(3);
  std::stop_source source;
  source.request_stop();
  std::atomic<int> developed = 0;
  EXPECT_THROW(render(subject.world, subject.view, subject.all, threads(3), pool,
                      source.get_token(), [&](const FilmTile&) { ++developed; }),
               Stopped);
  EXPECT_EQ(developed, 0);
}

// A picture of so many pixels that their sums alone take seconds to make: none are made before the
// first round comes to them.
TEST(Stop, EndsALargePictureThatIsWatchedWithin100Ms) {
  using Clock = std::chrono::steady_clock;
  const World world = compile(test::thesis_scene('a'));
  const int side = test::sanitized() ? 1024 : 4096;
  RenderOptions options = threads(2);
  options.integrator = IntegratorName::path;
  options.samples = 64;
  Pool pool(2);
  double nearest = 1e9;
  for (int i = 0; i < 3 && nearest > 100; ++i) {
    std::stop_source source;
    Clock::time_point left;
    options.watch = [&](const Glimpse&) {
      left = Clock::now();
      source.request_stop();
    };
    EXPECT_THROW(render(world, view_of(Camera{}, side, side), {0, 0, side, side}, options, pool,
                        source.get_token(), [](const FilmTile&) {}),
                 Stopped);
    const std::chrono::duration<double, std::milli> took = Clock::now() - left;
    nearest = std::min(nearest, took.count());
  }
  EXPECT_LT(nearest, 100);
}

TEST(Stop, PoolRendersTheNextPictureAsIfNothingHadHappened) {
  const Subject subject;
  Pool pool(3);
  LinearFilm before(640, 480), after(640, 480);
  const auto expose = [&](LinearFilm& film) {
    return render(subject.world, subject.view, subject.all, threads(3), pool, {},
                  [&](const FilmTile& tile) { film.put(tile); })
        .rays;
  };
  const RayCounts rays = expose(before);
  for (int i = 0; i < 20; ++i) {
    std::stop_source source;
    EXPECT_THROW(render(subject.world, subject.view, subject.all, threads(3), pool,
                        source.get_token(), [&](const FilmTile&) { source.request_stop(); }),
                 Stopped);
  }
  EXPECT_EQ(expose(after), rays);
  EXPECT_TRUE(test::bits_of(before.image()) == test::bits_of(after.image()));
}

TEST(Stop, WhatDevelopThrowsReachesTheCaller) {
  const Subject subject;
  for (const int count : {1, 4}) {
    Pool pool(count);
    EXPECT_THROW(render(subject.world, subject.view, subject.all, threads(count), pool, {},
                        [](const FilmTile& tile) {
                          if (tile.x == 320) throw std::runtime_error("disk full");
                        }),
                 std::runtime_error);
  }
}

}  // namespace
}  // namespace tia
