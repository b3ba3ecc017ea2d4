// How jobs share a pool's threads. Time is told by hand where only its amount matters: a task
// passes it.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <latch>
#include <list>
#include <memory>
#include <stdexcept>
#include <thread>
#include <vector>

#include "core/parallel/pool.h"
#include "tests/core/parallel/jobs.h"

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
// tasks began, beyond those that waited, while the small one had tasks left: which it had where
// those that were done and one more for each thread, which may be at it, are not all.
int overtaken(Pool& pool, const std::function<void(Nanoseconds)>& pass) {
  constexpr int small = 10;
  std::latch met(1), old(1);
  std::atomic<int> begun = 0, done = 0, too_soon = 0;
  const Poster big(pool, [&](int i) {
    if (++begun > pool.threads() + grown_old && done + pool.threads() < small) ++too_soon;
    if (i == grown_old) old.count_down();
    if (i >= grown_old) met.wait();
    pass(ms);
  });
  old.wait();
  pool.for_each(small, 64, {}, [&](int i) {
    if (i == 0) met.count_down();
    met.wait();
    pass(ms);
    ++done;
  });
  return too_soon;
}

TEST(FairPool, SmallJobStartsAtOnceAndIsDoneBeforeAnOlderOneGoesOn) {
  for (const int threads : {1, 2, 5}) {
    HandTime time;
    Pool pool(threads, time.clock());
    EXPECT_EQ(overtaken(pool, [&](Nanoseconds t) { time.pass(t); }), 0) << threads;
  }
}

TEST(FairPool, TrueTimeIsToldByTheSteadyClock) {
  Pool pool(2);
  EXPECT_EQ(overtaken(pool, pass_truly), 0);
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

// ---- tasks that give way ----------------------------------------------------------------------

/// A job without end whose every task is endless too, but gives way.
class Endless {
 public:
  /// It comes when all have that come at the same time.
  Endless(Pool& pool, std::uint64_t client, int tasks, std::latch* together = nullptr)
      : thread_([&pool, this, client, tasks, together](const std::stop_token& stop) {
          Flow flow{client};
          if (together != nullptr) together->arrive_and_wait();
          const auto task = [&](int) {
            ++begun;
            for (;;) {
              at_work.enter();
              ++rounds;
              at_work.leave();
              end_if_asked(stop);
            }
          };
          EXPECT_THROW(pool.for_each(tasks, tasks, stop, task, &flow), Stopped);
          attained = flow.attained;
        }) {}
  void stop() { thread_.request_stop(); }
  Nanoseconds end() {
    stop();
    thread_.join();
    return attained;
  }
  std::atomic<int> begun = 0;
  std::atomic<std::int64_t> rounds = 0;
  Crowd at_work;

 private:
  Nanoseconds attained = 0;
  std::jthread thread_;
};

TEST(GivingTasks, LetASmallJobOfAnotherClientBeDoneAndGoOn) {
  for (const int threads : {1, 2, 5}) {
    Pool pool(threads);
    Endless big(pool, 1, 64);
    while (big.begun < threads) std::this_thread::yield();
    Flow flow{2};
    std::atomic<int> done = 0;
    pool.for_each(
        100, 64, {}, [&](int) { ++done; }, &flow);
    EXPECT_EQ(done, 100);
    const std::int64_t then = big.rounds;
    while (big.rounds < then + 1000) std::this_thread::yield();
    EXPECT_LE(big.at_work.most(), threads + 1);
    EXPECT_GT(big.end(), 0);
  }
}

// Clients with one task each that has no end: every one of them has its share of the time.
TEST(GivingTasks, WithoutEndShareTheTimeEvenly) {
  Pool pool(2);
  constexpr int count = 4;
  std::latch together(count);
  std::list<Endless> clients;
  for (std::uint64_t client = 1; client <= count; ++client)
    clients.emplace_back(pool, client, 1, &together);
  std::this_thread::sleep_for(std::chrono::milliseconds(600));
  std::vector<Nanoseconds> had;
  for (Endless& each : clients) each.stop();  // all at the same time
  for (Endless& each : clients) had.push_back(each.end());
  const auto [least, most] = std::ranges::minmax(had);
  EXPECT_GT(2 * least, most);
}

// Eight jobs of one client, most of them parked within their tasks, do not keep all workers: the
// two tasks of another's, which wait for each other, end.
TEST(GivingTasks, OfParkedJobsLeaveWorkersForAnother) {
  Pool pool(4);
  std::atomic<int> begun = 0;
  std::list<std::jthread> jobs;
  for (int i = 0; i < 8; ++i)
    jobs.emplace_back([&](const std::stop_token& stop) {
      Flow flow{1};
      const auto task = [&](int) {
        ++begun;
        for (int n = 0; n < 50; ++n) {
          pass_truly(ms / 5);
          end_if_asked(stop);
        }
      };
      EXPECT_THROW(pool.for_each(endless, 64, stop, task, &flow), Stopped);
    });
  while (begun < 30) std::this_thread::yield();
  Flow flow{2};
  std::latch both(2);
  std::atomic<bool> met = false;
  const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  pool.for_each(
      2, 4, {},
      [&](int) {
        both.count_down();
        while (!both.try_wait() && std::chrono::steady_clock::now() < give_up) continue;
        if (both.try_wait()) met = true;
      },
      &flow);
  EXPECT_TRUE(met);
}

TEST(GivingTasks, EndWhenTheyAreStoppedAndWhenAnotherFails) {
  Pool pool(2);
  for (int round = 0; round < 30; ++round) {
    Endless old(pool, 1, 4), other(pool, 2, 4);
    std::stop_source none;
    EXPECT_THROW(pool.for_each(3, 3, {},
                               [&](int i) {
                                 for (int n = 0; n < 1000; ++n) end_if_asked({});
                                 if (i == round % 3) throw std::runtime_error("no");
                               }),
                 std::runtime_error);
    EXPECT_GE(old.end() + other.end(), 0);
  }
  std::atomic<int> done = 0;
  pool.for_each(1000, 2, {}, [&](int) { ++done; });
  EXPECT_EQ(done, 1000);
}

// No more of a job's tasks are begun than it may have hands: who is suspended goes on first.
TEST(GivingTasks, AreEndedBeforeOthersOfTheirJobBegin) {
  Pool pool(2);
  Endless rival(pool, 1, 2);
  std::atomic<int> open = 0, most = 0;
  Flow flow{2};
  const auto task = [&](int) {
    const int here = ++open;
    if (here > most) most = here;
    for (int n = 0; n < 300; ++n) {
      pass_truly(20'000);
      end_if_asked({});
    }
    --open;
  };
  pool.for_each(12, 2, {}, task, &flow);
  EXPECT_LE(most, 2);
  rival.end();
}

}  // namespace
}  // namespace tia
