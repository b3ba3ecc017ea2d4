// A farm's results in a store outside of its Redis: none is lost, none that is damaged is used, and
// nothing stays. And what a farm puts right that a Redis has forgotten.
#include <filesystem>
#include <fstream>
#include <map>

#include "server/contract/problem.h"
#include "server/jobs/redis_jobs.h"
#include "tests/server/jobs/store_kinds.h"
#include "tests/server/redis_support.h"
#include "tests/server/s3_support.h"

namespace tia::test {
namespace {

namespace fs = std::filesystem;

const std::string without_redis = RedisServer::program().empty() ? "redis-server" : "";

/// MemoryBlobs: a store of the test's own, for what needs no disk.
class MemoryBlobs : public server::Blobs {
 public:
  void put(const std::string& name, std::string_view bytes) override { kept_[name] = bytes; }
  std::optional<std::string> find(const std::string& name) override {
    const auto found = kept_.find(name);
    return found == kept_.end() ? std::nullopt : std::optional(found->second);
  }
  void remove(const std::string& name) override { kept_.erase(name); }
  std::vector<std::string> names(const std::string& prefix) override {
    std::vector<std::string> found;
    for (const auto& [name, bytes] : kept_)
      if (name.starts_with(prefix)) found.push_back(name);
    return found;
  }

 private:
  std::map<std::string, std::string> kept_;
};

INSTANTIATE_TEST_SUITE_P(RedisAndStore, JobStoreOf,
                         testing::Values(StoreKind{
                             "RedisAndStore", false,
                             [](const Folder&, const JobLimits& limits, TimeMs) {
                               return std::make_unique<RedisJobs>(
                                   FarmOptions{.redis = empty_redis().options(),
                                               .limits = limits,
                                               .name = "w",
                                               .store = std::make_shared<MemoryBlobs>()});
                             },
                             without_redis}),
                         [](const auto& info) { return info.param.name; });

/// Outside: a farm of one process whose results are in a folder.
class Outside : public testing::Test {
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
  void draw_all() {
    while (const auto claim = store->claim("", now)) store->finish(*claim, result("bytes"), now);
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

TEST_F(Outside, ADamagedResultOfAJobThatGoesOnIsDrawnAgainAndItsRaysCountOnce) {
  store->submit(job(3, true), now);
  for (int i = 0; i < 3; ++i) store->finish(*store->claim("", now), result("bytes"), now);
  ASSERT_EQ(files().size(), 3U);
  const auto join = store->claim("", now);
  ASSERT_TRUE(join);
  EXPECT_EQ(join->n, 3);
  std::ofstream(files()[1], std::ios::binary | std::ios::app) << 'x';
  int damaged = 0;
  for (int n = 0; n < 3; ++n) try {
      EXPECT_EQ(store->result("job", n), "bytes");
    } catch (const StorageError&) {
      ++damaged;
    }
  EXPECT_EQ(damaged, 1);
  EXPECT_EQ(store->find("job")->waiting, 1);
  EXPECT_EQ(store->find("job")->rays.primary, 10);
  store->lose(*join, Loss::failed, now);  // as who could not put them together
  const auto again = store->claim("", now);
  ASSERT_TRUE(again);
  EXPECT_LT(again->n, 3);
  EXPECT_FALSE(store->claim("", now)) << "not to be put together before";
  store->finish(*again, result("bytes"), now);
  const auto whole = store->claim("", now);
  ASSERT_TRUE(whole);
  store->finish(*whole, result("whole"), now);
  EXPECT_EQ(store->find("job")->state, JobState::done);
  EXPECT_EQ(store->find("job")->rays.all(), 3 * (5 + 4 + 3 + 2));
  EXPECT_EQ(store->result("job", 3), "whole");
  store->sweep(now);
  EXPECT_EQ(files().size(), 1U) << "pieces go once they are put together";
}

TEST_F(Outside, ADamagedResultOfAJobThatHasEndedIsNotServed) {
  store->submit(job(2), now);
  draw_all();
  for (const fs::path& file : files()) fs::resize_file(file, 2);
  EXPECT_THROW(store->result("job", 0), StorageError);
  fs::remove(files().front());
  EXPECT_THROW(store->result("job", 0), StorageError);
  EXPECT_THROW(store->result("job", 1), StorageError);
  EXPECT_EQ(store->find("job")->done, 2) << "after the last state nothing changes";
}

TEST_F(Outside, NothingIsTakenAsDoneThatIsNotThere) {
  store->submit(job(1), now);
  const auto claim = store->claim("", now);
  S3StandIn s3;
  FarmOptions away{.redis = shared_redis().options(), .name = "w", .lease_ms = 1};
  away.store = server::blobs_at("s3://tia-test", s3.options());
  s3.fail("PUT", S3StandIn::Fault::answers_500, 1000);
  EXPECT_THROW(RedisJobs(away).finish(*claim, result("bytes"), now), StorageAway);
  s3.fail("PUT", S3StandIn::Fault::is_full, 1000);
  EXPECT_THROW(RedisJobs(away).finish(*claim, result("bytes"), now), HttpError);
  EXPECT_EQ(store->find("job")->done, 0);
  s3.fail("PUT", S3StandIn::Fault::is_full, 0);
  RedisJobs back(away);
  EXPECT_TRUE(back.finish(*claim, result("bytes"), now));
  EXPECT_EQ(back.result("job", 0), "bytes");
  EXPECT_FALSE(back.finish(*claim, result("bytes"), now)) << "the same once more";
  EXPECT_EQ(s3.kept().size(), 1U) << "what is not taken is taken away";
}

TEST_F(Outside, LeavesNothingInStoreOrRedis) {
  const auto keys = [&] { return ask({"DBSIZE"}).count; };
  const auto round = [&] {
    store->submit(job(2, true), now);
    draw_all();
    store->cancel("job", now);
    store->submit(job(2), now);
    store->finish(*store->claim("", now), result("bytes"), now);
    fs::create_directories(folder.file("results/job"));
    std::ofstream(folder.file("results/job/0.part-0")) << "of one that was killed";
    store->cancel("job", now);
    store->cancel("job", now);
    store->submit(job(1), now);
    draw_all();
    now += keep_ms;
    store->sweep(now);
    EXPECT_TRUE(store->find("job")->is_gone);
    store->lend(
        "models/a", [] { return std::string("model"); }, now);
    now += keep_ms + 10'000;
    store->sweep(now);
    store->sweep(now);
    EXPECT_TRUE(files().empty()) << files().front();
    EXPECT_EQ(store->load(now).bytes, 0);
    return keys();
  };
  const auto before = round();
  EXPECT_EQ(round(), before);
}

TEST_F(Outside, WhatClientsHaveSentIsLentOnceAndAsLongAsAJobNeedsIt) {
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

TEST_F(Outside, ResultsAreKeptAsLongAsWhoTookTheJobSaysWhoeverEndsIt) {
  store->submit(job(1), now);
  RedisJobs other({.redis = shared_redis().options(), .limits = {.keep_ms = 5}, .name = "other"});
  other.finish(*other.claim("", now), result("bytes"), now);
  EXPECT_EQ(store->find("job")->expires, now + keep_ms);
}

TEST_F(Outside, RaysOfKeysJobsAreChargedOnceToWhoAsks) {
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
TEST_F(Outside, WhatRedisHasForgottenIsFedAgain) {
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
