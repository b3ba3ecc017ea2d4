#include "core/parallel/pool.h"

#include <gtest/gtest.h>

#include <atomic>
#include <barrier>
#include <chrono>
#include <mutex>
#include <set>
#include <stdexcept>

namespace tia {
namespace {

TEST(Pool, CallsEachTaskOnce) {
  for (const int threads : {1, 2, 7}) {
    Pool pool(threads);
    EXPECT_EQ(pool.threads(), threads);
    for (const int count : {0, 1, 2, 6, 1000}) {
      std::vector<std::atomic<int>> calls(static_cast<std::size_t>(count));
      pool.for_each(count, 64, {}, [&](int i) { ++calls[static_cast<std::size_t>(i)]; });
      for (const auto& each : calls) EXPECT_EQ(each, 1);
    }
  }
}

TEST(Pool, UsesNoMoreThreadsThanAskedFor) {
  Pool pool(4);
  for (const int most : {1, 2, 3}) {
    std::mutex mutex;
    std::set<std::thread::id> seen;
    pool.for_each(2000, most, {}, [&](int) {
      const std::lock_guard lock(mutex);
      seen.insert(std::this_thread::get_id());
    });
    EXPECT_LE(seen.size(), static_cast<std::size_t>(most));
  }
}

TEST(Pool, OneThreadIsTheCallersOwn) {
  Pool pool(4);
  const auto caller = std::this_thread::get_id();
  pool.for_each(100, 1, {}, [&](int) { EXPECT_EQ(std::this_thread::get_id(), caller); });
}

TEST(Pool, ThreadsWorkAtTheSameTime) {
  // Three tasks that wait for each other end only if three threads run them.
  Pool pool(3);
  std::barrier together(3);
  std::atomic<int> met = 0;
  pool.for_each(3, 3, {}, [&](int) {
    together.arrive_and_wait();
    ++met;
  });
  EXPECT_EQ(met, 3);
}

TEST(Pool, ThrowingTaskReachesTheCallerAndThePoolWorksOn) {
  for (const int threads : {1, 2, 7}) {
    Pool pool(threads);
    for (int round = 0; round < 50; ++round) {
      EXPECT_THROW(pool.for_each(100, threads, {},
                                 [&](int i) {
                                   if (i == round) throw std::invalid_argument("no");
                                 }),
                   std::invalid_argument);
      std::atomic<int> sum = 0;
      pool.for_each(100, threads, {}, [&](int i) { sum += i; });
      EXPECT_EQ(sum, 4950);
    }
  }
}

TEST(Pool, AfterAFailureNoThreadBeginsAnotherTask) {
  for (const int threads : {1, 4}) {
    Pool pool(threads);
    std::atomic<int> begun = 0;
    EXPECT_THROW(pool.for_each(1'000'000, threads, {},
                               [&](int) {
                                 ++begun;
                                 throw std::runtime_error("first");
                               }),
                 std::runtime_error);
    EXPECT_LE(begun, threads);
  }
}

TEST(Pool, StopEndsTheJobBetweenTasks) {
  for (const int threads : {1, 2, 7}) {
    Pool pool(threads);
    std::stop_source source;
    std::atomic<int> begun = 0;
    EXPECT_THROW(pool.for_each(1'000'000, threads, source.get_token(),
                               [&](int) {
                                 ++begun;
                                 source.request_stop();
                               }),
                 Stopped);
    EXPECT_LE(begun, threads);
  }
}

TEST(Pool, FailureCountsMoreThanStop) {
  Pool pool(2);
  std::stop_source source;
  EXPECT_THROW(pool.for_each(10, 2, source.get_token(),
                             [&](int) {
                               source.request_stop();
                               throw std::invalid_argument("no");
                             }),
               std::invalid_argument);
}

TEST(Pool, ManyCallersAtOnceEachGetTheirOwnJobDone) {
  Pool pool(3);
  constexpr int callers = 16, rounds = 100;
  std::barrier start(callers);
  std::atomic<int> right = 0;
  {
    std::vector<std::jthread> crowd;
    for (int c = 0; c < callers; ++c)
      crowd.emplace_back([&, c] {
        start.arrive_and_wait();
        for (int round = 0; round < rounds; ++round) {
          const int count = 1 + (c * 7 + round) % 50;
          std::atomic<int> sum = 0;
          pool.for_each(count, 1 + round % 4, {}, [&](int i) { sum += i + 1; });
          right += sum == count * (count + 1) / 2;
        }
      });
  }
  EXPECT_EQ(right, callers * rounds);
}

TEST(Pool, ManyCallersDoNotCatchEachOthersFailuresOrStops) {
  Pool pool(3);
  constexpr int callers = 12, rounds = 60;
  std::atomic<int> failed = 0, stopped = 0, done = 0;
  {
    std::vector<std::jthread> crowd;
    for (int c = 0; c < callers; ++c)
      crowd.emplace_back([&, c] {
        for (int round = 0; round < rounds; ++round) {
          std::stop_source source;
          try {
            pool.for_each(20, 3, source.get_token(), [&](int i) {
              if (c % 3 == 0 && i == 10) throw std::runtime_error("mine");
              if (c % 3 == 1 && i == 10) source.request_stop();
            });
            ++done;
          } catch (const Stopped&) {
            ++stopped;
          } catch (const std::runtime_error&) {
            ++failed;
          }
        }
      });
  }
  EXPECT_EQ(failed, callers / 3 * rounds);
  EXPECT_EQ(stopped, callers / 3 * rounds);
  EXPECT_EQ(done, callers / 3 * rounds);
}

TEST(Pool, TaskMayCallThePoolItself) {
  Pool pool(2);
  std::atomic<int> inner = 0;
  pool.for_each(4, 2, {}, [&](int) { pool.for_each(5, 2, {}, [&](int) { ++inner; }); });
  EXPECT_EQ(inner, 20);
}

// ---- work that its caller does alone --------------------------------------------------------

TEST(PoolAlone, IsDoneOnTheCallersThread) {
  Pool pool(3);
  std::thread::id on;
  pool.alone([&] { on = std::this_thread::get_id(); }, {});
  EXPECT_EQ(on, std::this_thread::get_id());
}

TEST(PoolAlone, WhatItThrowsReachesTheCallerAndThePoolWorksOn) {
  Pool pool(1);
  EXPECT_THROW(pool.alone([] { throw std::runtime_error("no"); }, {}), std::runtime_error);
  int done = 0;
  pool.alone([&] { ++done; }, {});
  pool.for_each(5, 1, {}, [&](int) { ++done; });
  EXPECT_EQ(done, 6);
}

// However many call: a thread each, but no more of them at work than the pool has, and one that is
// young.
TEST(PoolAlone, SharesThePoolsThreadsByTurns) {
  constexpr int threads = 2;
  Pool pool(threads);
  std::atomic<int> at_work = 0, most = 0, done = 0;
  std::vector<std::jthread> callers;
  for (std::uint64_t c = 1; c <= 8; ++c)
    callers.emplace_back([&, c] {
      Flow flow{c};
      pool.alone(
          [&] {
            const auto until = std::chrono::steady_clock::now() + std::chrono::milliseconds(60);
            while (std::chrono::steady_clock::now() < until) {
              const int now = ++at_work;
              for (int seen = most; seen < now && !most.compare_exchange_weak(seen, now);) continue;
              for (const auto end =
                       std::chrono::steady_clock::now() + std::chrono::microseconds(200);
                   std::chrono::steady_clock::now() < end;)
                continue;
              --at_work;
              end_if_asked({});
            }
          },
          {}, &flow);
      ++done;
    });
  callers.clear();
  EXPECT_EQ(done, 8);
  EXPECT_LE(most, threads + 1);
}

TEST(PoolAlone, GivesWayToASmallJobAndGoesOn) {
  Pool pool(1);
  std::atomic<bool> begun = false, small_done = false;
  bool saw_it = false;
  std::jthread small([&] {
    while (!begun) std::this_thread::yield();
    Flow flow{2};
    pool.for_each(
        1, 1, {}, [&](int) { small_done = true; }, &flow);
  });
  Flow flow{1};
  pool.alone(
      [&] {
        begun = true;
        const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(20);
        while (!small_done && std::chrono::steady_clock::now() < give_up) end_if_asked({});
        saw_it = small_done;
      },
      {}, &flow);
  EXPECT_TRUE(saw_it);
}

TEST(PoolAlone, EndsWhenItIsStoppedAtWorkOrWaiting) {
  Pool pool(1);
  std::stop_source stop;
  std::atomic<int> stopped = 0;
  {
    std::vector<std::jthread> callers;
    for (int i = 0; i < 3; ++i)
      callers.emplace_back([&] {
        try {
          pool.alone(
              [&] {
                for (;;) end_if_asked(stop.get_token());
              },
              stop.get_token());
        } catch (const Stopped&) {
          ++stopped;
        }
      });
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    stop.request_stop();
  }
  EXPECT_EQ(stopped, 3);
  int done = 0;
  pool.for_each(3, 1, {}, [&](int) { ++done; });
  EXPECT_EQ(done, 3);
}

// Three tasks that wait for each other end only if three threads run them: the caller's and both
// of the pool's, once and again.
TEST(PoolAlone, SharesWhatItCallsForEachFor) {
  Pool pool(3);
  std::barrier together(3);
  Flow flow{1};
  const Workers workers = pool.workers(3, {}, &flow);
  std::thread::id on;
  int inside = 0;
  workers.alone([&] {
    for (int i = 0; i < 2; ++i) workers.for_each(3, [&](int) { together.arrive_and_wait(); });
    on = std::this_thread::get_id();
    pool.alone([&] { ++inside; }, {});  // at once, for it is its turn again
  });
  EXPECT_EQ(on, std::this_thread::get_id());
  EXPECT_EQ(inside, 1);
  EXPECT_GT(flow.attained, 0);
}

TEST(PoolAlone, WhatASharedPartThrowsEndsItAndThePoolWorksOn) {
  Pool pool(2);
  const auto fails = [](int) { throw std::runtime_error("no"); };
  EXPECT_THROW(pool.alone([&] { pool.for_each(4, 2, {}, fails); }, {}), std::runtime_error);
  int done = 0;
  pool.alone([&] { ++done; }, {});
  pool.for_each(5, 1, {}, [&](int) { ++done; });
  EXPECT_EQ(done, 6);
}

// No client's many small shared parts make it a new one, who would be let in front each time.
TEST(PoolAlone, GoesOnWithItsServiceFromPartToPart) {
  std::atomic<Nanoseconds> now = 0;
  Pool pool(2, [&] { return now.load(); });
  Flow flow{1};
  pool.alone(
      [&] {
        for (int i = 0; i < 10; ++i) {
          now += 1'000'000;
          pool.for_each(
              2, 2, {}, [](int) {}, &flow);
        }
      },
      {}, &flow);
  EXPECT_EQ(flow.attained, 10'000'000);
  EXPECT_EQ(flow.place, flow.credit_end - Turns::credit + 10'000'000);
}

TEST(PoolAlone, MayBeCalledInsideOfATask) {
  Pool pool(2);
  int done = 0;
  pool.for_each(1, 1, {}, [&](int) { pool.alone([&] { ++done; }, {}); });
  EXPECT_EQ(done, 1);
}

}  // namespace
}  // namespace tia
