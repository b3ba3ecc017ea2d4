// How jobs share a pool's threads. Time is told by hand where only its amount matters: a task
// passes it.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <latch>
#include <memory>
#include <thread>
#include <vector>

#include "core/render/pool.h"
#include "tests/core/render/jobs.h"

namespace tia {
namespace {

using test::endless;
using test::ms;

struct HandTime {
  std::atomic<Nanoseconds> now = 0;
  Pool::Clock clock() {
    return [this] { return now.load(); };
  }
  void pass(Nanoseconds time) { now += time; }
};

void pass_truly(Nanoseconds time) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::nanoseconds(time);
  while (Clock::now() < end) continue;
}

/// How many are at something at once, and how many ever were.
class Crowd {
 public:
  void enter() {
    const int here = ++here_;
    for (int most = most_; here > most && !most_.compare_exchange_weak(most, here);) continue;
  }
  void leave() { --here_; }
  int most() const { return most_; }

 private:
  std::atomic<int> here_ = 0, most_ = 0;
};

constexpr int grown_old = 60;  // tasks of one ms: more than a credit

/// A job without end, until it is stopped.
class Poster {
 public:
  Poster(Pool& pool, const std::function<void(int)>& task, int max_threads = 64)
      : thread_([&pool, task, max_threads](const std::stop_token& stop) {
          EXPECT_THROW(pool.for_each(endless, max_threads, stop, task), Stopped);
        }) {}

 private:
  std::jthread thread_;
};

// A big job grows old, then waits in its tasks for a small one. Returns: how many of the big one's
// tasks began while the small one had tasks left.
int overtaken(Pool& pool, const std::function<void(Nanoseconds)>& pass) {
  std::latch met(1), old(1);
  std::atomic<int> begun = 0;
  const Poster big(pool, [&](int i) {
    ++begun;
    if (i == grown_old) old.count_down();
    if (i >= grown_old) met.wait();
    pass(ms);
  });
  old.wait();
  int before = 0, after = 0;
  pool.for_each(10, 64, {}, [&](int i) {
    if (i == 0) {
      before = pool.threads() + grown_old;
      met.count_down();
    }
    if (i == 9) after = begun;
    met.wait();
    pass(ms);
  });
  return after - before;
}

TEST(FairPool, SmallJobStartsAtOnceAndIsDoneBeforeAnOlderOneGoesOn) {
  for (const int threads : {1, 2, 5}) {
    HandTime time;
    Pool pool(threads, time.clock());
    EXPECT_LE(overtaken(pool, [&](Nanoseconds t) { time.pass(t); }), 0) << threads;
  }
}

TEST(FairPool, TrueTimeIsToldByTheSteadyClock) {
  Pool pool(2);
  EXPECT_LE(overtaken(pool, pass_truly), 0);
}

TEST(FairPool, NoMoreThanOneThreadTooManyHoweverManyCallersCome) {
  constexpr int callers = 64, tasks = 40;
  for (const int threads : {1, 2, 5}) {
    HandTime time;
    Pool pool(threads, time.clock());
    Crowd all;
    std::atomic<int> done = 0;
    {
      std::latch start(callers);
      std::vector<std::jthread> crowd;
      for (int c = 0; c < callers; ++c)
        crowd.emplace_back([&, c] {
          const int most = 1 + c % 3;
          Crowd own;
          start.arrive_and_wait();
          pool.for_each(tasks, most, {}, [&](int) {
            all.enter();
            own.enter();
            time.pass(c % 8 == 0 ? 10 * ms : ms);
            ++done;
            own.leave();
            all.leave();
          });
          EXPECT_LE(own.most(), most);
        });
    }
    EXPECT_EQ(done, callers * tasks);
    EXPECT_LE(all.most(), threads + 1);
  }
}

TEST(FairPool, WhoWaitsForItsTurnIsStoppedAtOnce) {
  Pool pool(1);
  std::latch busy(1), leave(1);
  std::jthread first([&] {
    pool.for_each(1, 1, {}, [&](int) {
      busy.count_down();
      leave.wait();
    });
  });
  busy.wait();
  int begun = 0;
  std::jthread second([&](const std::stop_token& stop) {
    EXPECT_THROW(pool.for_each(5, 1, stop, [&](int) { ++begun; }), Stopped);
  });
  second.request_stop();
  second.join();
  leave.count_down();
  EXPECT_EQ(begun, 0);
}

}  // namespace
}  // namespace tia
