// The laws of jobs' state machine, on every store by the same text: random walks against a model,
// turns, tries, what a crash leaves.
#include <algorithm>
#include <atomic>
#include <map>
#include <memory>
#include <random>
#include <thread>

#include "server/access/access.h"
#include "server/contract/problem.h"
#include "server/jobs/sqlite_jobs.h"
#include "tests/server/jobs/store_kinds.h"

namespace tia::test {
namespace {

StoreKind kept_by_sqlite(const std::string& name, bool is_on_disk) {
  return {name, is_on_disk, [=](const Folder& folder, const JobLimits& limits, TimeMs now) {
            const std::string path = is_on_disk ? folder.file(SqliteJobs::name) : "";
            return std::make_unique<SqliteJobs>(path, limits, now);
          }};
}
INSTANTIATE_TEST_SUITE_P(Stores, JobStoreOf,
                         testing::Values(kept_by_sqlite("InMemory", false),
                                         kept_by_sqlite("OnDisk", true)),
                         [](const auto& info) { return info.param.name; });

/// Model: a job in the few words that its laws need.
struct Model {
  struct Part {
    PartState state = PartState::waiting;
    int tries = 0;
  };
  std::vector<Part> parts;
  bool joins = false, is_gone = false;
  JobState state = JobState::queued;
  TimeMs finished = 0;
  int told = 0;  // done, by the last event of progress
  Part join{};

  Part& at(int n) { return n < static_cast<int>(parts.size()) ? parts[std::size_t(n)] : join; }
  int count(PartState in) const {
    return static_cast<int>(
        std::count_if(parts.begin(), parts.end(), [=](auto& part) { return part.state == in; }));
  }
  void end(JobState as, TimeMs now) {
    state = as, finished = now;
    for (Part& part : parts)
      if (part.state == PartState::leased) part.state = PartState::waiting;
  }
  void claimed(int n) {
    state = JobState::running;
    at(n).state = PartState::leased, ++at(n).tries;
  }
  void finish(int n, TimeMs now) {
    at(n).state = PartState::done;
    if ((joins ? join.state : PartState::done) == PartState::done &&
        count(PartState::done) == static_cast<int>(parts.size()))
      end(JobState::done, now);
  }
  void lose(int n, bool given_back, int tries, TimeMs now) {
    Part& part = at(n);
    part.tries -= given_back;
    part.state = part.tries >= tries ? PartState::dead : PartState::waiting;
    if (part.state == PartState::dead) end(JobState::failed, now);
  }
};

void expect_same(JobStore& store, const std::string& id, Model& model,
                 std::map<std::string, std::int64_t>& events) {
  const auto job = store.find(id);
  ASSERT_TRUE(job) << id;
  EXPECT_EQ(job->state, model.state) << id;
  EXPECT_EQ(job->is_gone, model.is_gone);
  EXPECT_EQ(job->waiting + job->leased + job->done + job->dead, job->parts);
  if (model.is_gone) return;
  EXPECT_EQ(job->waiting, model.count(PartState::waiting));
  EXPECT_EQ(job->leased, model.count(PartState::leased));
  EXPECT_EQ(job->done, model.count(PartState::done));
  EXPECT_EQ(job->dead, model.count(PartState::dead));
  EXPECT_EQ(job->problem.empty(), job->state != JobState::failed);
  for (const PartRow& part : store.parts(id, {}, 0, 1000)) {
    EXPECT_EQ(part.state, model.at(part.n).state) << part.n;
    const bool is_kept = part.state == PartState::done &&
                         (!is_last(model.state) || (model.state == JobState::done && !model.joins));
    EXPECT_EQ(store.result(id, part.n).has_value(), is_kept) << part.n;
  }
  if (model.joins)
    EXPECT_EQ(store.result(id, job->parts).has_value(), model.state == JobState::done);
  for (const JobEvent& event : store.events(id, events[id], 100'000)) {
    EXPECT_EQ(event.id, ++events[id]) << event.name;
    if (event.name != "progress") continue;
    const auto told = static_cast<int>(number_at(parse_json(event.data), "done"));
    EXPECT_GE(told, std::exchange(model.told, told)) << "progress falls";
  }
  EXPECT_EQ(job->events, events[id]);
}

TEST_P(JobStoreOf, WalksAsItsModelDoes) {
  limits.tries = 2;
  open();
  std::mt19937 random(5);
  const auto below = [&](int n) { return static_cast<int>(random() % unsigned(n)); };
  std::map<std::string, Model> models;
  std::map<std::string, std::int64_t> events;
  std::vector<Claim> claims;
  int restarts = 0, done = 0, dead = 0;
  for (int step = 0; step < std::max(test::rounds(600), 300); ++step) {
    now += below(20);
    const auto any_claim = [&] { return std::size_t(below(static_cast<int>(claims.size()))); };
    const int what = below(100);
    if (what < 8) {
      NewJob made = job(std::to_string(step), 1 + below(6), std::to_string(below(3)));
      made.joins = below(2) == 0;
      store->submit(made, now);
      models[made.id].parts.resize(std::size_t(made.parts));
      models[made.id].joins = made.joins;
    } else if (what < 50) {
      if (const auto claim = store->claim("w", now)) {
        Model& of = models.at(claim->job);
        ASSERT_EQ(of.at(claim->n).state, PartState::waiting);
        ASSERT_FALSE(is_last(of.state));
        of.claimed(claim->n);
        claims.push_back(*claim);
      }
    } else if (what < 90 && !claims.empty()) {
      const std::size_t i = any_claim();
      const Claim claim = claims[i];
      claims.erase(claims.begin() + std::ptrdiff_t(i));
      Model& of = models.at(claim.job);
      const bool is_wanted = !is_last(of.state) && of.at(claim.n).state == PartState::leased &&
                             of.at(claim.n).tries == claim.attempt;
      EXPECT_EQ(store->heartbeat(claim, now), is_wanted);
      if (what < 75) {
        EXPECT_EQ(store->finish(claim, {.bytes = "x"}, now), is_wanted);
        if (is_wanted) of.finish(claim.n, now);
      } else {
        const bool given_back = what < 82;
        store->lose(claim, given_back ? Loss::given_back : Loss::failed, now);
        if (is_wanted) of.lose(claim.n, given_back, limits.tries, now);
      }
    } else if (what < 92 && !models.empty()) {
      auto& [id, of] = *std::next(models.begin(), below(static_cast<int>(models.size())));
      if (is_last(of.state)) continue;
      EXPECT_EQ(store->cancel(id, now), Cancelled::now);
      of.end(JobState::cancelled, now);
    } else if (what < 96) {
      store->sweep(now);
      for (auto each = models.begin(); each != models.end();) {
        Model& of = each->second;
        of.is_gone = is_last(of.state) && of.finished + keep_ms <= now;
        const bool removed = of.is_gone && of.finished + 2 * keep_ms <= now;
        if (removed) EXPECT_FALSE(store->find(each->first));
        each = removed ? models.erase(each) : std::next(each);
      }
      std::erase_if(claims, [&](auto& each) { return !models.contains(each.job); });
    } else if (what < 98 && GetParam().takes_up) {
      open();
      ++restarts;
      claims.clear();
      for (auto& [id, of] : models)
        for (int n = 0; n <= static_cast<int>(of.parts.size()); ++n)
          if (!is_last(of.state) && of.at(n).state == PartState::leased)
            of.lose(n, false, limits.tries, now);
    }
    for (auto& [id, of] : models) {
      if (of.state == JobState::done) ++done;
      if (of.state == JobState::failed) ++dead;
      if (below(4) == 0) expect_same(*store, id, of, events);
      if (HasFatalFailure() || HasNonfatalFailure()) FAIL() << "step " << step << ": " << what;
    }
  }
  EXPECT_GT(done, 0);
  EXPECT_GT(dead, 0);
  EXPECT_EQ(restarts > 0, GetParam().takes_up);
}

TEST_P(JobStoreOf, ASmallJobIsNotHeldUpByALargeOne) {
  store->submit(job("large", 1000), now);
  for (int i = 0; i < 5; ++i) finish_next();
  store->submit(job("small", 10), now);
  int of_large = 0;
  while (store->find("small")->state != JobState::done) of_large += finish_next() == "large";
  EXPECT_LT(of_large, 1000 / 20);
}

TEST_P(JobStoreOf, OwnersShareByHalvesHoweverManyJobsEachHas) {
  for (int i = 0; i < 10; ++i) store->submit(job("many-" + std::to_string(i), 100, "many"), now);
  store->submit(job("one", 100, "one"), now);
  int of_one = 0;
  for (int i = 0; i < 100; ++i) of_one += finish_next() == "one";
  EXPECT_EQ(of_one, 50);
}

TEST_P(JobStoreOf, HighGoesFirstAndLowIsNotStarved) {
  for (const Priority priority : {Priority::low, Priority::normal, Priority::high}) {
    NewJob made = job(std::string(tia::name_of(priority)), 1000);
    made.priority = priority;
    store->submit(made, now);
  }
  std::map<std::string, int> shares;
  for (int i = 0; i < 80; ++i) ++shares[finish_next()];
  EXPECT_EQ(shares["low"], 10);
  EXPECT_EQ(shares["high"], 70);
}

TEST_P(JobStoreOf, OneKeyIsOneJob) {
  NewJob made = job("first", 1);
  made.key = "k", made.digest = "d";
  store->submit(made, now);
  made.id = "second";
  EXPECT_EQ(store->submit(made, now).id, "first");
  made.digest = "other";
  EXPECT_THROW(store->submit(made, now), InputError);
  made.owner = "b";
  EXPECT_EQ(store->submit(made, now).id, "second");
}

TEST_P(JobStoreOf, TakesNoMoreThanItMay) {
  limits.unfinished = 2, limits.bytes = 10'000;
  open();
  store->submit(job("a", 1), now);
  store->submit(job("b", 1), now);
  EXPECT_THROW(store->submit(job("c", 1), now), HttpError);
  const auto first = store->claim("w", now), second = store->claim("w", now);
  EXPECT_TRUE(store->finish(*first, {.bytes = std::string(7000, 'x')}, now));
  EXPECT_TRUE(store->result(first->job, 0));
  EXPECT_TRUE(store->finish(*second, {.bytes = std::string(7000, 'x')}, now));
  EXPECT_TRUE(store->find(first->job)->is_gone) << "the oldest one has made room";
  store->submit(job("d", 1), now);
  EXPECT_THROW(store->finish(*store->claim("w", now), {.bytes = std::string(11'000, 'x')}, now),
               HttpError);
}

// However many come at once; each account for itself, of which all who have no key are one.
TEST_P(JobStoreOf, TakesNoMoreOfAnOwnerThanItsLimits) {
  std::atomic<int> refused = 0;
  const auto submit = [&](const std::string& id, const std::string& owner) {
    NewJob made = job(id, 1, owner);
    made.limits = {3, 10'000};
    try {
      store->submit(made, now);
    } catch (const AccessRefusal& refusal) {
      EXPECT_EQ(refusal.type(), "quota");
      ++refused;
    }
  };
  for (const char* owner : {"key a", "key b", "10.0.0."}) {
    refused = 0;
    std::vector<std::jthread> clients;
    for (int i = 0; i < 8; ++i)
      clients.emplace_back([&, i] {
        const bool is_key = owner[0] == 'k';
        submit(owner + std::to_string(i), is_key ? owner : owner + std::to_string(i));
      });
    clients.clear();
    EXPECT_EQ(refused, 5) << owner;
    EXPECT_EQ(store->sums_of({.owner = owner}).unfinished, 3) << owner;
  }
  while (const auto claim = store->claim("w", now))
    EXPECT_TRUE(store->finish(*claim, {.bytes = std::string(3000, 'x')}, now));
  EXPECT_EQ(store->sums_of({.owner = "key a"}).unfinished, 0);
  EXPECT_GT(store->sums_of({.owner = "key a"}).bytes, 9000);
  refused = 0;
  submit("more", "key a");
  submit("other", "key c");
  EXPECT_EQ(refused, 1) << "of its bytes";
  for (const std::string& id : store->ids(0, 100)) {
    store->cancel(id, now);
    store->cancel(id, now);
  }
  for (const char* owner : {"key a", "key c", "10.0.0.1"})
    EXPECT_EQ(store->sums_of({.owner = owner}).bytes, 0) << owner;
}

TEST_P(JobStoreOf, TellsUnfinishedOnesFirstAndTheLatestOfThem) {
  for (const char* id : {"a", "b", "c", "d"}) store->submit(job(id, 1), ++now);
  EXPECT_EQ(store->ids(0, 100), (std::vector<std::string>{"d", "c", "b", "a"}));
  store->cancel("d", ++now);
  store->cancel("b", ++now);
  EXPECT_EQ(store->ids(0, 100), (std::vector<std::string>{"c", "a", "b", "d"}));
  EXPECT_EQ(store->ids(1, 2), (std::vector<std::string>{"a", "b"}));
}

// Three are under way when the process ends, and again whenever the third one is drawn.
TEST_P(JobStoreOf, OnlyThePartThatEndsProcessesLosesItsTries) {
  if (!GetParam().takes_up) GTEST_SKIP() << "there is nothing to take up";
  store->submit(job("killer", 3), now);
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(store->claim("w", now));
  while (store->find("killer")->state != JobState::failed) {
    open();
    for (auto claim = store->claim("w", now); claim; claim = store->claim("w", now)) {
      EXPECT_FALSE(store->claim("v", now)) << "one at a time";
      if (claim->n == 2) break;
      EXPECT_EQ(claim->attempt, 2);
      store->finish(*claim, {.bytes = "x"}, now);
    }
  }
  const auto parts = store->parts("killer", {}, 0, 10);
  EXPECT_EQ(parts[2].state, PartState::dead);
  EXPECT_EQ(parts[2].tries, limits.tries);
  EXPECT_EQ(parts[0].tries, 2);
  EXPECT_THAT(store->find("killer")->problem, testing::HasSubstr("part 2"));
}

TEST_P(JobStoreOf, LeavesNothingBehind) {
  for (int i = 0; i < 50; ++i) store->submit(job(std::to_string(i), 2), now);
  while (!finish_next().empty()) {
  }
  now += keep_ms;
  store->sweep(now);
  EXPECT_TRUE(store->find("7")->is_gone);
  EXPECT_FALSE(store->result("7", 0));
  now += keep_ms;
  store->sweep(now);
  EXPECT_FALSE(store->find("7"));
  EXPECT_TRUE(store->events("7", 0, 10).empty());
  const JobLoad load = store->load(now);
  EXPECT_EQ(load.bytes, 0);
  EXPECT_EQ(load.jobs_unfinished, 0);
}

TEST_P(JobStoreOf, EndsWhatIsOverItsDeadline) {
  NewJob made = job("late", 2);
  made.deadline = now + 100;
  store->submit(made, now);
  store->sweep(now + 99);
  EXPECT_EQ(store->find("late")->state, JobState::queued);
  store->sweep(now + 100);
  EXPECT_EQ(store->find("late")->state, JobState::failed);
}

TEST_P(JobStoreOf, PlansAnewWhatIsOfAnotherVersion) {
  NewJob made = job("old", 3);
  made.version = "1";
  store->submit(made, now);
  finish_next();
  ASSERT_EQ(store->of_other_versions("2").size(), 1U);
  Job anew = *store->find("old");
  anew.version = "2", anew.parts = 2;
  store->plan_anew(anew, now);
  EXPECT_TRUE(store->of_other_versions("2").empty());
  EXPECT_EQ(store->find("old")->waiting, 2);
  EXPECT_FALSE(store->result("old", 0));
}

}  // namespace
}  // namespace tia::test
