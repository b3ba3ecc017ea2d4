// What a farm adds to the laws of all stores: leases that run out, results that come late, workers
// that draw other bytes.
#include "server/jobs/redis_jobs.h"

#include <atomic>

#include "server/contract/problem.h"
#include "tests/server/jobs/store_kinds.h"
#include "tests/server/redis_support.h"

namespace tia::test {
namespace {

const std::string lacking_redis = RedisServer::program().empty() ? "redis-server" : "";

INSTANTIATE_TEST_SUITE_P(Redis, JobStoreOf,
                         testing::Values(StoreKind{
                             "Redis", false,
                             [](const Folder&, const JobLimits& limits, TimeMs) {
                               return std::make_unique<RedisJobs>(
                                   FarmOptions{.redis = empty_redis().options(),
                                               .limits = limits,
                                               .name = "w"});
                             },
                             lacking_redis}),
                         [](const auto& info) { return info.param.name; });

/// Farm: processes' stores, each by a name, of one Redis.
class Farm : public testing::Test {
 protected:
  void SetUp() override {
    if (!lacking_redis.empty()) GTEST_SKIP() << lacking_redis << " is not installed";
    empty_redis();
  }
  std::unique_ptr<RedisJobs> as(const std::string& name, int lease_ms = 60'000,
                                FarmRole role = FarmRole::all) const {
    return std::make_unique<RedisJobs>(FarmOptions{.redis = shared_redis().options(),
                                                   .limits = {.tries = 3},
                                                   .name = name,
                                                   .role = role,
                                                   .lease_ms = lease_ms,
                                                   .audit = audit});
  }
  static NewJob batch(int parts) {
    return {.id = "job", .owner = "o", .kind = "batch", .request = "{}", .parts = parts};
  }
  /// A lease that its process does no longer keep alive, as if that had been killed.
  std::optional<Claim> claimed_by_one_who_dies(int lease_ms) const {
    return as("dies", lease_ms)->claim("", 1);
  }
  std::optional<Claim> claimed(RedisJobs& store) const {
    std::optional<Claim> claim;
    eventually([&] { return (claim = store.claim("", 1)).has_value(); }, seconds(5));
    return claim;
  }
  double audit = 0;
};

TEST_F(Farm, AnotherTakesAPartWhoseWorkerIsNotHeardOfAndTheLateResultCountsForNothing) {
  const auto store = as("lives", 80);
  store->submit(batch(1), 1);
  const auto first = claimed_by_one_who_dies(80);
  ASSERT_TRUE(first);
  EXPECT_FALSE(as("patient")->claim("", 1)) << "its lease goes on";
  const auto second = claimed(*store);
  ASSERT_TRUE(second);
  EXPECT_EQ(second->attempt, 2);
  const auto late = as("dies");
  EXPECT_FALSE(late->heartbeat(*first, 1));
  EXPECT_FALSE(late->finish(*first, {.bytes = "x"}, 1));
  EXPECT_EQ(store->find("job")->done, 0);
  EXPECT_TRUE(store->finish(*second, {.bytes = "x"}, 1));
  EXPECT_FALSE(late->finish(*first, {.bytes = "x"}, 1)) << "the same once more";
  const Job job = *store->find("job");
  EXPECT_EQ(job.done, 1);
  EXPECT_EQ(job.state, JobState::done);
  EXPECT_EQ(store->load(1).farm->reclaims, 1);
  EXPECT_EQ(store->load(1).farm->mismatches, 0);
}

TEST_F(Farm, KeepsAPartThatIsBeingDrawnHoweverLongItTakes) {
  const auto drawing = as("draws", 300), other = as("other", 300);
  drawing->submit(batch(1), 1);
  const auto claim = drawing->claim("", 1);
  ASSERT_TRUE(claim);
  const auto start = Clock::now();
  while (Clock::now() - start < milliseconds(700)) ASSERT_FALSE(other->claim("", 1));
  EXPECT_TRUE(drawing->finish(*claim, {.bytes = "x"}, 1));
}

TEST_F(Farm, APartThatKillsWhoeverDrawsItIsDeadAfterItsTriesAndNamed) {
  const auto store = as("lives", 20);
  store->submit(batch(1), 1);
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(claimed(*as("dies", 20))) << i;
  EXPECT_TRUE(eventually([&] {
    static_cast<void>(as("dies", 20)->claim("", 1));
    return store->find("job")->state == JobState::failed;
  }));
  EXPECT_THAT(store->find("job")->problem, testing::HasSubstr("part 0"));
  EXPECT_EQ(store->parts("job", PartState::dead, 0, 9).size(), 1U);
}

TEST_F(Farm, OtherBytesOfAnAuditedPartFailTheJobAndBothWorkersLeave) {
  audit = 1;
  const auto right = as("right"), wrong = as("wrong");
  right->submit(batch(3), 1);
  const auto first = right->claim("", 1);
  ASSERT_TRUE(wrong->claim("", 1));  // a second worker is there
  EXPECT_TRUE(right->finish(*first, {.bytes = "x"}, 1));
  EXPECT_EQ(right->find("job")->done, 0) << "not before another has drawn it";
  const auto again = wrong->claim("", 1);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->n, first->n);
  EXPECT_FALSE(wrong->finish(*again, {.bytes = "y"}, 1));
  const Job job = *right->find("job");
  EXPECT_EQ(job.state, JobState::failed);
  EXPECT_THAT(job.problem, testing::AllOf(testing::HasSubstr("by wrong than by right"),
                                          testing::HasSubstr("part 0")));
  EXPECT_THROW(right->claim("", 1), StorageError);
  EXPECT_THROW(wrong->claim("", 1), StorageError);
  EXPECT_TRUE(right->is_banned());
  EXPECT_EQ(as("third")->load(1).farm->mismatches, 1);
}

TEST_F(Farm, WhoDrawsOtherBytesIsFoundWithinFiveHundredPartsByAuditsOfAHundredth) {
  audit = 0.01;
  const auto right = as("right"), wrong = as("wrong");
  right->submit(batch(500), 1);
  for (int i = 0; i < 600 && !is_last(right->find("job")->state); ++i) {
    RedisJobs& store = i % 2 == 0 ? *right : *wrong;
    if (const auto claim = store.claim("", 1))
      store.finish(*claim, {.bytes = i % 2 == 0 ? "x" : "y"}, 1);
  }
  const Job job = *right->find("job");
  EXPECT_EQ(job.state, JobState::failed);
  EXPECT_LT(job.done, 500);
  EXPECT_THAT(job.problem,
              testing::AllOf(testing::HasSubstr("wrong"), testing::HasSubstr("right")));
}

// No picture is of two versions: what one has drawn is no part of what the next has planned.
TEST_F(Farm, EachVersionDrawsItsOwnJobsAlone) {
  const auto of = [](const std::string& version) {
    return std::make_unique<RedisJobs>(FarmOptions{
        .redis = shared_redis().options(), .version = version, .name = "of-" + version});
  };
  const auto old = of("1"), newer = of("2");
  NewJob job = batch(2);
  job.version = "1";
  old->submit(job, 1);
  EXPECT_FALSE(newer->claim("", 1));
  const auto claim = old->claim("", 1);
  ASSERT_TRUE(claim);
  EXPECT_TRUE(newer->of_other_versions("2").empty()) << "the old one is still at work";
  Job anew = *newer->find("job");
  anew.version = "2";
  newer->plan_anew(anew, 1);
  EXPECT_FALSE(old->finish(*claim, {.bytes = "x"}, 1));
  EXPECT_FALSE(old->claim("", 1));
  for (int n = 0; n < 2; ++n) EXPECT_TRUE(newer->finish(*newer->claim("", 1), {.bytes = "y"}, 1));
  EXPECT_EQ(newer->find("job")->state, JobState::done);
  EXPECT_EQ(newer->result("job", 0), "y");
}

TEST_F(Farm, AnAuditedPartIsDoneOnceTwoWorkersHaveDrawnTheSameOrThereIsOnlyOne) {
  audit = 1;
  const auto one = as("one");
  one->submit(batch(2), 1);
  EXPECT_TRUE(one->finish(*one->claim("", 1), {.bytes = "x"}, 1));
  EXPECT_EQ(one->find("job")->done, 1) << "there is nobody else";
  const auto claim = one->claim("", 1);
  const auto two = as("two");
  EXPECT_FALSE(two->claim("", 1));
  EXPECT_TRUE(one->finish(*claim, {.bytes = "x"}, 1));
  EXPECT_FALSE(one->claim("", 1)) << "not by the same";
  const auto again = two->claim("", 1);
  ASSERT_TRUE(again);
  EXPECT_TRUE(two->finish(*again, {.bytes = "x"}, 1));
  EXPECT_EQ(one->find("job")->state, JobState::done);
  EXPECT_EQ(one->load(1).farm->audits, 1);
}

TEST_F(Farm, ALateResultOfOtherBytesIsAMismatch) {
  const auto store = as("lives", 30);
  NewJob job = batch(1);
  job.joins = true;
  store->submit(job, 1);
  const auto first = claimed_by_one_who_dies(30);
  const auto second = claimed(*store);
  ASSERT_TRUE(second);
  EXPECT_TRUE(store->finish(*second, {.bytes = "x"}, 1));
  EXPECT_FALSE(as("dies")->finish(*first, {.bytes = "y"}, 1));
  EXPECT_EQ(store->find("job")->state, JobState::failed);
}

TEST_F(Farm, WorkersDrawAndWhoServesPutsTogether) {
  const auto draws = as("draws", 60'000, FarmRole::draws);
  const auto joins = as("serves", 60'000, FarmRole::joins);
  NewJob job = batch(1);
  job.joins = true;
  joins->submit(job, 1);
  EXPECT_FALSE(joins->claim("", 1));
  EXPECT_TRUE(draws->finish(*draws->claim("", 1), {.bytes = "x"}, 1));
  EXPECT_FALSE(draws->claim("", 1));
  const auto join = joins->claim("", 1);
  ASSERT_TRUE(join);
  EXPECT_EQ(join->n, 1);
  joins->lose(*join, Loss::given_back, 1);
  EXPECT_TRUE(joins->finish(*joins->claim("", 1), {.bytes = "whole", .etag = "e"}, 1));
  EXPECT_EQ(draws->find("job")->etag, "e");
  EXPECT_EQ(draws->result("job", 1), "whole");
}

TEST_F(Farm, WhatOneChangesAnotherIsTold) {
  std::atomic<int> told = 0;
  const auto hears = as("hears");
  hears->changed = [&](const std::string& id) { told += id == "job"; };
  hears->listen();
  const auto does = as("does");
  EXPECT_TRUE(eventually([&] {
    does->submit(batch(1), 1);
    does->cancel("job", 1);
    return told > 0;
  }));
  hears->hush();
}

TEST_F(Farm, WithoutRedisNothingIsPromised) {
  RedisServer redis(true);
  RedisJobs store({.redis = redis.options(), .name = "w"});
  store.submit(batch(2), 1);
  const auto claim = store.claim("", 1);
  redis.kill();
  EXPECT_THROW(store.submit(batch(1), 1), StorageError);
  EXPECT_THROW(store.find("job"), StorageError);
  EXPECT_FALSE(store.is_up());
  redis.start();
  EXPECT_EQ(store.find("job")->leased, 1) << "it was on the disk";
  EXPECT_TRUE(store.finish(*claim, {.bytes = "x"}, 1));
  EXPECT_TRUE(store.is_up());
}

TEST_F(Farm, AFullRedisSaysSoAndKeepsWhatItHas) {
  RedisServer redis(false, {"--maxmemory", "24mb", "--maxmemory-policy", "noeviction"});
  RedisJobs store({.redis = redis.options(), .name = "w"});
  store.submit(batch(40), 1);
  const auto first = store.claim("", 1);
  try {
    for (int i = 0; i < 40; ++i)
      store.finish(i == 0 ? *first : *store.claim("", 1), {.bytes = std::string(1 << 20, 'x')}, 1);
    FAIL() << "40 megabytes in 24";
  } catch (const HttpError& error) {
    EXPECT_EQ(error.type(), "storage-full");
  }
  const Job job = *store.find("job");
  EXPECT_GT(job.done, 0);
  EXPECT_EQ(job.waiting + job.leased + job.done, 40);
  for (int n = 0; n < job.done; ++n) EXPECT_TRUE(store.result("job", n)) << n;
}

TEST_F(Farm, LeavesNoKeysBehind) {
  const auto store = as("w");
  const auto keys = [] { return server::Redis(shared_redis().options()).call({"DBSIZE"}).count; };
  const auto round = [&] {
    NewJob job = batch(2);
    job.key = "k", job.joins = true, job.deadline = 1000;
    store->submit(job, 1);
    while (const auto claim = store->claim("", 1)) store->finish(*claim, {.bytes = "x"}, 1);
    store->cancel("job", 1);
    store->submit(batch(2), 1);
    static_cast<void>(store->claim("", 1));
    store->cancel("job", 1);
    store->cancel("job", 1);
    return keys();
  };
  const auto before = round();
  EXPECT_EQ(round(), before);
  EXPECT_EQ(store->load(1).bytes, 0);
  EXPECT_EQ(store->load(1).parts_leased, 0);
  EXPECT_EQ(store->load(1).parts_waiting, 0);
}

}  // namespace
}  // namespace tia::test
