// Results in a store outside of jobs' own, of every kind of those by the same text: none is lost,
// none that is damaged is used, and nothing stays.
#include <filesystem>
#include <fstream>
#include <map>

#include "server/contract/problem.h"
#include "server/jobs/redis_jobs.h"
#include "server/jobs/sqlite_jobs.h"
#include "tests/server/jobs/store_kinds.h"
#include "tests/server/redis_support.h"
#include "tests/server/s3_support.h"

namespace tia::test {
namespace {

namespace fs = std::filesystem;
using server::Blobs;

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

constexpr int usual_lease_ms = 15'000;

/// OutsideKind: a store of jobs whose results are elsewhere.
struct OutsideKind {
  std::string name;
  bool takes_up = false;
  std::function<std::unique_ptr<JobStore>(const Folder&, const JobLimits&, TimeMs now,
                                          std::shared_ptr<Blobs>, int lease_ms)>
      open;
  /// Rows or keys that it holds, once it is closed.
  std::function<std::int64_t(const Folder&)> size;
  std::string lacks = {};
};
void PrintTo(const OutsideKind& kind, std::ostream* out) { *out << kind.name; }

const OutsideKind redis_kind{
    "RedisAndStore", false,
    [](const Folder&, const JobLimits& limits, TimeMs, std::shared_ptr<Blobs> outside,
       int lease_ms) {
      return std::make_unique<RedisJobs>(FarmOptions{.redis = shared_redis().options(),
                                                     .limits = limits,
                                                     .name = "w",
                                                     .lease_ms = lease_ms,
                                                     .store = std::move(outside)});
    },
    [](const Folder&) { return server::Redis(shared_redis().options()).call({"DBSIZE"}).count; },
    RedisServer::program().empty() ? "redis-server" : ""};

const OutsideKind sqlite_kind{
    "SqliteAndStore", true,
    [](const Folder& folder, const JobLimits& limits, TimeMs now, std::shared_ptr<Blobs> outside,
       int) {
      return std::make_unique<SqliteJobs>(folder.file(SqliteJobs::name), limits, now,
                                          std::move(outside));
    },
    [](const Folder& folder) {
      server::Database file(folder.file(SqliteJobs::name), 0);
      std::int64_t rows = 0;
      for (const char* table : {"jobs", "parts", "results", "outside", "dropped", "events"})
        rows += std::stoll(file.word(std::string("SELECT count(*) FROM ") + table));
      return rows;
    }};

const auto name_of_kind = [](const auto& info) { return info.param.name; };

StoreKind with_store_in_memory(const OutsideKind& kind) {
  const auto outside = std::make_shared<MemoryBlobs>();
  return {kind.name, kind.takes_up,
          [=](const Folder& folder, const JobLimits& limits, TimeMs now) {
            if (!kind.takes_up) empty_redis();
            return kind.open(folder, limits, now, outside, usual_lease_ms);
          },
          kind.lacks};
}
INSTANTIATE_TEST_SUITE_P(AndStore, JobStoreOf,
                         testing::Values(with_store_in_memory(redis_kind),
                                         with_store_in_memory(sqlite_kind)),
                         name_of_kind);

/// Outside: jobs of one process whose results are in a folder.
class Outside : public testing::TestWithParam<OutsideKind> {
 protected:
  static constexpr TimeMs keep_ms = 1000;

  void SetUp() override {
    if (!GetParam().lacks.empty()) GTEST_SKIP() << GetParam().lacks << " is not installed";
    if (!GetParam().takes_up) empty_redis();
    store = with(server::blobs_at("dir:" + folder.file(""), {}));
  }
  std::unique_ptr<JobStore> with(std::shared_ptr<Blobs> outside, int lease_ms = usual_lease_ms) {
    store.reset();
    return GetParam().open(own, {.tries = 3, .keep_ms = keep_ms}, now, std::move(outside),
                           lease_ms);
  }
  static NewJob job(int parts, bool joins = false) {
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

  Folder folder, own;
  TimeMs now = 1'000'000;
  std::unique_ptr<JobStore> store;
};
INSTANTIATE_TEST_SUITE_P(Jobs, Outside, testing::Values(redis_kind, sqlite_kind), name_of_kind);

TEST_P(Outside, ADamagedResultOfAJobThatGoesOnIsDrawnAgainAndItsRaysCountOnce) {
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

TEST_P(Outside, ADamagedResultOfAJobThatHasEndedIsNotServed) {
  store->submit(job(2), now);
  draw_all();
  for (const fs::path& file : files()) fs::resize_file(file, 2);
  EXPECT_THROW(store->result("job", 0), StorageError);
  fs::remove(files().front());
  EXPECT_THROW(store->result("job", 0), StorageError);
  EXPECT_THROW(store->result("job", 1), StorageError);
  EXPECT_EQ(store->find("job")->done, 2) << "after the last state nothing changes";
}

TEST_P(Outside, NothingIsTakenAsDoneThatIsNotThere) {
  S3StandIn s3;
  store = with(server::blobs_at("s3://tia-test", s3.options()), 300);
  store->submit(job(1), now);
  const auto claim = store->claim("", now);
  s3.fail("PUT", S3StandIn::Fault::answers_500, 1000);
  EXPECT_THROW(store->finish(*claim, result("bytes"), now), StorageAway);
  s3.fail("PUT", S3StandIn::Fault::is_full, 1000);
  EXPECT_THROW(store->finish(*claim, result("bytes"), now), HttpError);
  EXPECT_EQ(store->find("job")->done, 0);
  s3.fail("PUT", S3StandIn::Fault::is_full, 0);
  EXPECT_TRUE(store->finish(*claim, result("bytes"), now));
  EXPECT_EQ(store->result("job", 0), "bytes");
  EXPECT_FALSE(store->finish(*claim, result("bytes"), now)) << "the same once more";
  EXPECT_EQ(s3.kept().size(), 1U) << "what is not taken is taken away";
}

TEST_P(Outside, LeavesNothingInItOrInTheStore) {
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
    store.reset();
    const std::int64_t left = GetParam().size(own);
    store = with(server::blobs_at("dir:" + folder.file(""), {}));
    return left;
  };
  const auto before = round();
  EXPECT_EQ(round(), before);
}

// Only a store that takes up what was left knows of them.
TEST_P(Outside, AStoreThatIsNamedNoMoreOrForTheFirstTimeEndsWhatGoesOn) {
  if (!GetParam().takes_up) GTEST_SKIP() << "a farm's processes all name the same";
  store->submit(job(2, true), now);
  store->finish(*store->claim("", now), result("bytes"), now);
  store = with(nullptr);
  store->finish(*store->claim("", now), result("bytes"), now);
  EXPECT_THROW(store->result("job", 0), StorageError);
  EXPECT_EQ(store->result("job", 1), "bytes");
  store->finish(*store->claim("", now), result("bytes"), now);
  store = with(server::blobs_at("dir:" + folder.file(""), {}));
  store->finish(*store->claim("", now), result("whole"), now);
  EXPECT_EQ(store->result("job", 2), "whole");
  store->sweep(now);
  EXPECT_EQ(files().size(), 1U);
}

}  // namespace
}  // namespace tia::test
