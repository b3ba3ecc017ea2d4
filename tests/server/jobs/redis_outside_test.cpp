// What a farm keeps for others outside of its Redis, and what it puts right that a Redis has
// forgotten.
#include <filesystem>
#include <fstream>

#include "server/contract/problem.h"
#include "server/jobs/redis_jobs.h"
#include "tests/server/jobs/store_kinds.h"
#include "tests/server/redis_support.h"

namespace tia::test {
namespace {

namespace fs = std::filesystem;

const std::string without_redis = RedisServer::program().empty() ? "redis-server" : "";

/// FarmOutside: a farm of one process whose results are in a folder.
class FarmOutside : public testing::Test {
 protected:
  static constexpr TimeMs keep_ms = 1000;

  void SetUp() override {
    if (!without_redis.empty()) GTEST_SKIP() << without_redis << " is not installed";
    empty_redis();
    redis = std::make_unique<server::Redis>(shared_redis().options());
    store = as("w");
  }
  std::unique_ptr<RedisJobs> as(const std::string& name, FarmRole role = FarmRole::all) const {
    return std::make_unique<RedisJobs>(
        FarmOptions{.redis = shared_redis().options(),
                    .limits = {.tries = 3, .keep_ms = keep_ms},
                    .name = name,
                    .role = role,
                    .store = server::blobs_at("dir:" + folder.file(""), {})});
  }
  NewJob job(int parts, bool joins = false) const {
    return {.id = "job",
            .owner = "o",
            .kind = "batch",
            .request = "{}",
            .parts = parts,
            .joins = joins};
  }
  static PartResult result(const std::string& bytes) {
    return {.bytes = bytes,
            .place = R"("frame":0,"counted":[5,4,3,2,1])",
            .rays = {.primary = 5, .shadow = 4, .reflection = 3, .refraction = 2, .cut = 1}};
  }
  std::vector<fs::path> files() const {
    std::vector<fs::path> found;
    for (const auto& each : fs::recursive_directory_iterator(folder.file("")))
      if (each.is_regular_file()) found.push_back(each.path());
    std::ranges::sort(found);
    return found;
  }
  RedisReply ask(const std::vector<std::string_view>& words) { return redis->call(words); }

  Folder folder;
  TimeMs now = 1'000'000;
  std::unique_ptr<server::Redis> redis;
  std::unique_ptr<RedisJobs> store;
};

TEST_F(FarmOutside, WhatClientsHaveSentIsLentOnceAndAsLongAsAJobNeedsIt) {
  int asked = 0;
  const auto bytes = [&] {
    ++asked;
    return std::string("model");
  };
  store->lend("models/a", bytes, now);
  as("other")->lend("models/a", bytes, now);
  EXPECT_EQ(asked, 1);
  const auto worker = as("worker", FarmRole::draws);
  EXPECT_EQ(worker->lent("models/a"), "model");
  EXPECT_FALSE(worker->lent("models/b"));
  NewJob made = job(1);
  made.needs = "models/a models/b";
  store->submit(made, now);
  for (int i = 0; i < 3; ++i) {
    now += 20'000;
    store->sweep(now);
    EXPECT_EQ(worker->lent("models/a"), "model") << "the job is unfinished";
  }
  store->cancel("job", now);
  now += 20'000;
  store->sweep(now);
  EXPECT_FALSE(worker->lent("models/a"));
  store->lend("models/a", bytes, now);
  std::ofstream(files().front(), std::ios::binary) << "other";
  EXPECT_THROW(worker->lent("models/a"), StorageError);
}

// Without a store: no script has them as an argument, and they are held against their SHA-256.
TEST_F(FarmOutside, LongResultsAreBlobsInRedisThatGoWithTheirJob) {
  const std::string p(RedisJobs::prefix), longest(8 << 20, 'x'), longer = longest + 'x';
  const auto blobs = [&] { return ask({"KEYS", p + "blob:*"}).items; };
  RedisJobs plain({.redis = shared_redis().options(), .name = "plain"});
  for (const bool joins : {true, false}) {
    plain.submit(job(1, joins), now);
    EXPECT_TRUE(plain.finish(*plain.claim("", now), result(joins ? longer : longest), now));
    EXPECT_EQ(blobs().size(), joins ? 1U : 0U);
    if (joins) EXPECT_TRUE(plain.finish(*plain.claim("", now), result(longer), now));
    EXPECT_EQ(blobs().size(), joins ? 1U : 0U) << "pieces go once they are put together";
    EXPECT_EQ(plain.result("job", joins ? 1 : 0), joins ? longer : longest);
    if (joins) {
      EXPECT_EQ(ask({"PTTL", blobs()[0].words}).count, -1);
      ask({"SETRANGE", blobs()[0].words, "7", "y"});
      EXPECT_THROW(plain.result("job", 1), StorageError);
    }
    plain.cancel("job", now);
    EXPECT_TRUE(blobs().empty());
  }
  EXPECT_EQ(ask({"EXISTS", p + "dropped"}).count, 0);
  server::blobs_in_redis(*redis, p + "blob:")->put("of-one-that-was-killed", "x");
  EXPECT_GT(ask({"TTL", p + "blob:of-one-that-was-killed"}).count, 0);
}

TEST_F(FarmOutside, ResultsAreKeptAsLongAsWhoTookTheJobSaysWhoeverEndsIt) {
  store->submit(job(1), now);
  RedisJobs other({.redis = shared_redis().options(), .limits = {.keep_ms = 5}, .name = "other"});
  other.finish(*other.claim("", now), result("bytes"), now);
  EXPECT_EQ(store->find("job")->expires, now + keep_ms);
}

TEST_F(FarmOutside, RaysOfKeysJobsAreChargedOnceToWhoAsks) {
  NewJob made = job(3);
  made.owner = "key alice";
  store->submit(made, now);
  const auto worker = as("worker", FarmRole::draws), serves = as("serves", FarmRole::joins);
  for (int i = 0; i < 2; ++i) worker->finish(*worker->claim("", now), result("bytes"), now);
  PartResult found = result("bytes");
  found.is_found = true;
  worker->finish(*worker->claim("", now), found, now);
  EXPECT_TRUE(worker->take_charges().empty()) << "it has nobody's counts";
  const auto charges = serves->take_charges();
  ASSERT_EQ(charges.size(), 1U);
  EXPECT_EQ(charges[0].key, "alice");
  EXPECT_EQ(charges[0].rays, 2 * (5 + 4 + 3 + 2));
  EXPECT_TRUE(store->take_charges().empty());
}

// What a Redis that takes another's place may lack, piece by piece.
TEST_F(FarmOutside, WhatRedisHasForgottenIsFedAgain) {
  const std::string p(RedisJobs::prefix), key = p + "job:job";
  store->submit(job(4, true), now);
  for (int i = 0; i < 2; ++i) store->finish(*store->claim("", now), result("bytes"), now);
  ask({"HDEL", key + ":outside", "1"});  // a result
  ASSERT_EQ(store->claim("", now)->n, 2);
  ask({"DEL", p + "q::normal"});                             // a lease
  ask({"DEL", p + "turns::normal", p + "turns::normal:o"});  // whose turn it is
  const auto serves = as("serves", FarmRole::joins);
  serves->sweep(now);
  EXPECT_EQ(store->find("job")->waiting, 3);
  EXPECT_EQ(store->find("job")->done, 1);
  for (int i = 0; i < 3; ++i) {
    const auto claim = store->claim("", now);
    ASSERT_TRUE(claim) << i;
    store->finish(*claim, result("bytes"), now);
  }
  ask({"DEL", p + "joins:"});  // that its parts are all there
  EXPECT_FALSE(store->claim("", now));
  serves->sweep(now + 10'000);
  ASSERT_TRUE(store->claim("", now));
  serves->sweep(now + 20'000);
  EXPECT_FALSE(store->claim("", now)) << "what is as it was is left alone";
}

TEST(FarmWithoutWrites, SaysThatItIsAwayAndKeepsWhatItHas) {
  if (!without_redis.empty()) GTEST_SKIP() << without_redis << " is not installed";
  RedisServer server;
  RedisJobs store({.redis = server.options(), .name = "w"});
  const NewJob job{.id = "job", .owner = "o", .kind = "batch", .request = "{}", .parts = 1};
  store.submit(job, 1);
  const auto claim = store.claim("", 1);
  server::Redis redis(server.options());
  redis.call({"CONFIG", "SET", "min-replicas-to-write", "1"});  // as a master that lost the others
  NewJob second = job;
  second.id = "second";
  EXPECT_THROW(store.submit(second, 1), StorageAway);
  EXPECT_EQ(store.find("job")->leased, 1);
  redis.call({"CONFIG", "SET", "min-replicas-to-write", "0"});
  EXPECT_TRUE(store.finish(*claim, {.bytes = "x"}, 1));
  redis.call({"CONFIG", "SET", "requirepass", "secret"});
  EXPECT_THROW(RedisJobs({.redis = server.options(), .name = "w"}).find("job"), StorageAway);
}

}  // namespace
}  // namespace tia::test
