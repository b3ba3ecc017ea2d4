// Quotas that several servers count together: the laws of one, and what Redis' absence does to
// them.
#include "server/access/shared_quotas.h"

#include <thread>

#include "tests/server/access/access_support.h"
#include "tests/server/http/wire.h"
#include "tests/server/redis_support.h"

namespace tia::test {
namespace {

constexpr std::int64_t day = 20'000;

/// Replicas: two processes' quotas.
class SharedQuotasOf : public testing::Test {
 protected:
  void SetUp() override {
    if (RedisServer::program().empty()) GTEST_SKIP() << "redis-server is not installed";
    empty_redis();
  }
  static std::unique_ptr<SharedQuotas> of(const RedisServer& redis) {
    return std::make_unique<SharedQuotas>(redis.options(), milliseconds(20));
  }
};

// By the clock, as servers ask: how many are taken in t seconds is at most rate t + burst, and, of
// who asks again and again before it is full, not much less.
TEST_F(SharedQuotasOf, RequestsOfTwoServersAreOneBucket) {
  const RequestRate rate = RequestRate::of(200, 100);
  const auto a = of(shared_redis()), b = of(shared_redis());
  std::atomic<int> taken = 0;
  const auto start = Clock::now();
  {
    std::vector<std::jthread> clients;
    for (SharedQuotas* each : {a.get(), a.get(), b.get()})
      clients.emplace_back([&, each] {
        while (ms_since(start) < 300) {
          const RequestsLeft left = each->take("a", rate, system_time());
          taken += left.is_taken;
          EXPECT_EQ(left.wait > 0, left.left == 0);
        }
      });
  }
  const double seconds = ms_since(start) / 1000;
  EXPECT_LE(taken, 200 * seconds + 100);
  EXPECT_GE(taken, 200 * 0.15 + 100);
  EXPECT_TRUE(a->take("b", rate, system_time()).is_taken) << "another key's";
}

TEST_F(SharedQuotasOf, RaysOfTwoServersAreOneSum) {
  const auto a = of(shared_redis()), b = of(shared_redis());
  {
    std::vector<std::jthread> clients;
    for (SharedQuotas* each : {a.get(), a.get(), b.get()})
      clients.emplace_back([=] {
        for (int i = 1; i <= 20; ++i) each->add_rays("k", day, i);
      });
  }
  for (const auto* each : {&a, &b}) {
    EXPECT_EQ((*each)->add_rays("k", day, 0), 3 * 210);
    EXPECT_EQ((*each)->rays("k", day), 3 * 210);
    EXPECT_EQ((*each)->add_rays("k", day + 1, 0), 0);
  }
}

// What each has counted alone is there once Redis is, also in one that has lost all.
TEST_F(SharedQuotasOf, WithoutRedisEachCountsForItselfAndNothingTwice) {
  for (const bool forgets : {false, true}) {
    RedisServer redis(!forgets);
    const auto a = of(redis), b = of(redis);
    const RequestRate rate = RequestRate::of(0.01, 3);
    a->add_rays("k", day, 100);
    EXPECT_EQ(b->add_rays("k", day, 10), 110);
    EXPECT_TRUE(a->take("k", rate, system_time()).is_taken);
    redis.kill();
    EXPECT_EQ(a->add_rays("k", day, 1), 101) << "what it knew, and its own";
    EXPECT_EQ(b->add_rays("k", day, 2), 112);
    EXPECT_TRUE(a->take("k", rate, system_time()).is_taken);
    EXPECT_TRUE(a->take("k", rate, system_time()).is_taken);
    EXPECT_FALSE(a->take("k", rate, system_time()).is_taken);
    redis.start();
    EXPECT_TRUE(eventually([&] {  // both have to ask: Redis learns from each what it has counted
      a->add_rays("k", day, 0);
      return b->add_rays("k", day, 0) == 113;
    }));
    EXPECT_EQ(a->add_rays("k", day, 0), 113);
    EXPECT_FALSE(a->take("k", rate, system_time()).is_taken) << "the bucket was emptied alone";
    EXPECT_FALSE(b->take("k", rate, system_time()).is_taken) << "which the other one learns";
  }
}

// What the connections' thread decides waits for no other machine.
TEST_F(SharedQuotasOf, WhatIsAnsweredAtOnceAsksNobody) {
  const KeyFiles files(entry_of("a", R"("requests_per_s":1000)") + "," + entry_of("b"));
  Metrics metrics;
  Access access(files.config, metrics, system_time, of(shared_redis()));
  Request limited = asking_as("a", "/"), free = asking_as("b", "/");
  access.identify(limited), access.identify(free);
  EXPECT_FALSE(access.takes(limited, {Right::render}));
  EXPECT_TRUE(access.takes(free, {Right::render}));
  EXPECT_NO_THROW(access.admit(limited, {Right::render}));
}

// One script each: what it adds to a request, in the median.
TEST_F(SharedQuotasOf, AddLittleToARequest) {
  const auto a = of(shared_redis());
  const RequestRate rate = RequestRate::of(1e6, 1000);
  std::vector<double> took;
  for (int i = 0; i < test::rounds(500, 50); ++i) {
    const auto start = Clock::now();
    a->take("a", rate, system_time());
    took.push_back(ms_since(start));
  }
  std::ranges::nth_element(took, took.begin() + std::ptrdiff_t(took.size() / 2));
  RecordProperty("check_us", std::to_string(1000 * took[took.size() / 2]));
  std::printf("a check takes %.0f us\n", 1000 * took[took.size() / 2]);
  if (!sanitized()) EXPECT_LE(took[took.size() / 2], 5);
}

}  // namespace
}  // namespace tia::test
