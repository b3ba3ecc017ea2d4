// The laws of sharing, on processors and times that are played.
#include "core/parallel/turns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <list>
#include <memory>
#include <vector>

#include "tests/core/parallel/jobs.h"

namespace tia {
namespace {

using test::endless;
using test::ms;

/// Jobs whose tasks take as long as they say, on hands that are at once where they are called.
class Play {
 public:
  struct Job : Turn {
    Job(int tasks, int most, Nanoseconds each, std::uint64_t whose)
        : Turn(tasks, most, own), cost(each) {
      own.client = whose;
    }
    Flow own{};
    const Nanoseconds cost;
    Nanoseconds came = 0, had = 0;
  };

  explicit Play(int threads) : turns_(threads) {}
  Nanoseconds now() const { return now_; }
  const std::list<Job>& all() const { return jobs_; }
  std::size_t most_at_once() const { return most_at_once_; }

  Job& come(int tasks, Nanoseconds cost, int most = 64, std::uint64_t whose = 0,
            bool is_background = false) {
    Job& job = jobs_.emplace_back(tasks, most, cost, whose);
    job.own.is_background = job.own.is_long = is_background;
    job.came = now_;
    turns_.enter(job, now_);
    call();
    return job;
  }
  /// That another client waits for it, too.
  void join(Job& job, std::uint64_t whose) {
    turns_.also_for(job.own, whose, now_);
    call();
  }
  /// Until some job is over, which leaves. Returns: it, or null when the time has come.
  Job* run(Nanoseconds until) {
    while (!hands_.empty()) {
      const auto hand = std::min_element(hands_.begin(), hands_.end(), sooner);
      if (hand->end > until) break;
      now_ = hand->end;
      if (Job* over = end_task(hand)) return over;
    }
    now_ = until;
    return nullptr;
  }
  /// Until that one is over.
  void finish(const Job& job) {
    while (run(now_ + endless * ms) != &job) continue;
  }

 private:
  struct Hand {
    Job* job;
    Nanoseconds end;
  };
  static bool sooner(const Hand& a, const Hand& b) { return a.end < b.end; }

  Job* end_task(std::list<Hand>::iterator hand) {
    Job& job = *hand->job;
    turns_.spend(job, job.cost, now_);
    job.had += job.cost;
    if (job.has_tasks() && turns_.stays(job, now_)) {
      take(*hand);
      return nullptr;
    }
    Turns::end(job, now_);
    turns_.dismiss(job);
    hands_.erase(hand);
    if (job.is_over()) turns_.leave(job, now_);
    call();
    return job.is_over() ? &job : nullptr;
  }
  void call() {
    while (Turn* turn = turns_.next(now_, [](const Turn&) { return true; })) {
      turns_.call(*turn, now_);
      Turns::begin(*turn, now_);
      take(hands_.emplace_back(Hand{static_cast<Job*>(turn), 0}));
    }
    most_at_once_ = std::max(most_at_once_, hands_.size());
  }
  void take(Hand& hand) {
    ++hand.job->next;
    hand.end = now_ + hand.job->cost;
  }

  Turns turns_;
  Nanoseconds now_ = 1'000'000 * ms;
  std::list<Job> jobs_;
  std::list<Hand> hands_;
  std::size_t most_at_once_ = 0;
};

TEST(Turns, SmallJobHasAllThreadsWhileItIsWithinItsCredit) {
  for (const int threads : {1, 2, 16}) {
    Play play(threads);
    const Play::Job& big = play.come(endless, 3 * ms);
    play.run(play.now() + 1000 * ms);
    const Nanoseconds before = big.had;
    const Play::Job& small = play.come(40, ms);
    play.finish(small);
    // The tasks in hand when it came, and one each where it had none left for all threads.
    EXPECT_LE(big.had - before, 2 * threads * 3 * ms) << threads;
    EXPECT_LE(play.now() - small.came, 3 * ms + (40 / threads + 2) * ms) << threads;
  }
}

TEST(Turns, YoungJobWaitsForNobodysTask) {
  Play play(2);
  play.come(endless, 500 * ms);
  play.run(play.now() + 1200 * ms);
  const Play::Job& small = play.come(3, ms);
  play.finish(small);
  EXPECT_EQ(play.now() - small.came, 3 * ms);
}

TEST(Turns, OneThreadTooManyAtMostHoweverManyComeAtOnce) {
  Play play(2);
  play.come(endless, 100 * ms);
  play.run(play.now() + 1000 * ms);
  EXPECT_EQ(play.most_at_once(), 2U);
  std::vector<const Play::Job*> young;
  for (int i = 0; i < 100; ++i) young.push_back(&play.come(20, ms));
  while (play.run(play.now() + 10'000 * ms) != nullptr) continue;
  EXPECT_EQ(play.most_at_once(), 3U);
  for (const Play::Job* job : young) EXPECT_TRUE(job->is_over());
}

TEST(Turns, ThreadOfAnOldJobLeavesAtTheEndOfItsTaskWhereThereIsOneTooMany) {
  Play play(2);
  const Play::Job& big = play.come(endless, ms);
  play.run(play.now() + 1000 * ms);
  const Nanoseconds before = big.had;
  play.finish(play.come(40, ms, 1));
  EXPECT_LE(big.had - before, (40 + 2) * ms);
}

TEST(Turns, EqualClientsShareTheTimeHoweverLongTheirTasks) {
  for (const int threads : {1, 2, 5}) {
    for (const Nanoseconds cost : {ms / 4, ms, 30 * ms}) {
      Play play(threads);
      const Play::Job &a = play.come(endless, ms, 64, 1), &b = play.come(endless, cost, 64, 2);
      for (int i = 0; i < 100; ++i) {
        play.run(play.now() + 100 * ms);
        EXPECT_LE(std::abs(a.had - b.had), Turns::slice + threads * (cost + ms))
            << threads << ", " << cost;
      }
    }
  }
}

TEST(Turns, LaterClientIsAheadByItsCreditAndThenEven) {
  Play play(2);
  const Play::Job& first = play.come(endless, ms, 64, 1);
  play.run(play.now() + 5000 * ms);
  const Nanoseconds before = first.had;
  const Play::Job& second = play.come(endless, ms, 64, 2);
  play.run(play.now() + 3000 * ms);
  const Nanoseconds lead = second.had - (first.had - before);
  EXPECT_GE(lead, Turns::credit - Turns::slice - 4 * ms);
  EXPECT_LE(lead, Turns::credit + Turns::slice + 4 * ms);
}

TEST(Turns, StreamOfSmallJobsLeavesEachBigOneHalfOfAnEvenShare) {
  for (const int streams : {1, 2, 7}) {
    Play play(2);
    const Play::Job& big = play.come(endless, ms);
    play.run(play.now() + 1000 * ms);
    const Nanoseconds before = big.had, start = play.now();
    for (int i = 0; i < streams; ++i) play.come(10, ms);
    while (play.now() < start + 10'000 * ms)  // who is done comes again
      if (play.run(start + 10'000 * ms) != nullptr) play.come(10, ms);
    const Nanoseconds all = 2 * 10'000 * ms, lag = 2 * Turns::credit;
    EXPECT_GE(big.had - before, all / (2 * (streams + 1)) - lag) << streams;
    EXPECT_LE(big.had - before, all * 6 / 10) << streams;  // nor does the stream stand still
  }
}

TEST(Turns, FewThreadsSaveUpNoClaimToAll) {
  // One client on a single thread falls behind another on fifteen. A third one comes: it begins
  // near the first, but must not keep the second waiting until all that is made up for.
  Play play(16);
  const Play::Job& narrow = play.come(endless, ms, 1, 1);
  const Play::Job& wide = play.come(endless, ms, 64, 2);
  play.run(play.now() + 60'000 * ms);
  EXPECT_GT(wide.had, 10 * narrow.had);
  const Nanoseconds before = wide.had;
  const Play::Job& third = play.come(endless, ms, 64, 3);
  play.run(play.now() + 1000 * ms);
  EXPECT_LE(third.had - (wide.had - before), Turns::arrears + Turns::credit + 40 * ms);
}

TEST(Turns, NoJobHasMoreHandsThanItMay) {
  Play play(8);
  const Play::Job &a = play.come(endless, ms, 3), &b = play.come(endless, ms, 1);
  const Nanoseconds start = play.now();
  play.run(start + 1000 * ms);
  EXPECT_EQ(a.had, 3 * 1000 * ms);
  EXPECT_EQ(b.had, 1000 * ms);
}

// ---- long jobs ------------------------------------------------------------------------------

TEST(Turns, LongJobsOfOneClientEndOneAfterTheOther) {
  Play play(2);
  std::vector<const Play::Job*> jobs;
  for (int i = 0; i < 4; ++i) jobs.push_back(&play.come(1500, 2 * ms));
  const Nanoseconds start = play.now(), alone = 1500 * ms;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    while (!jobs[i]->is_over()) ASSERT_NE(play.run(play.now() + endless * ms), nullptr);
    // All take turns until they are known to be long, then the oldest has all threads.
    const auto n = static_cast<Nanoseconds>(i + 1);
    EXPECT_LE(play.now() - start, n * alone + 3 * Turns::long_service) << i;
  }
  EXPECT_LE(play.now() - start, 4 * alone + 50 * ms);  // and no thread has been idle
}

TEST(Turns, WhatTheOldestLongJobCannotUseTheNextOneHas) {
  Play play(4);
  const Play::Job &narrow = play.come(endless, ms, 1), &next = play.come(endless, ms),
                  &last = play.come(endless, ms);
  play.run(play.now() + 2000 * ms);
  const Nanoseconds before[] = {narrow.had, next.had, last.had};
  play.run(play.now() + 1000 * ms);
  EXPECT_GE(narrow.had - before[0], 990 * ms);
  EXPECT_GE(next.had - before[1], 2980 * ms);
  EXPECT_LE(last.had - before[2], 20 * ms);
}

TEST(Turns, AStreamOfSmallJobsLeavesTheOldestLongOneItsShareAndTheParkedNone) {
  Play play(2);
  const Play::Job &oldest = play.come(endless, ms), &parked = play.come(endless, ms);
  play.run(play.now() + 2000 * ms);
  const Nanoseconds had[] = {oldest.had, parked.had}, start = play.now();
  play.come(10, ms);
  while (play.now() < start + 10'000 * ms)
    if (play.run(start + 10'000 * ms) != nullptr) play.come(10, ms);
  EXPECT_GE(oldest.had - had[0], 20'000 * ms / 4 - 2 * Turns::credit);
  EXPECT_LE(parked.had - had[1], 10 * ms);
}

// ---- clients --------------------------------------------------------------------------------

// Who waits for what another has begun has it by his own turns, not behind all that the other
// wants: whether he comes before or after it has become long and is parked.
TEST(Turns, WhatAnotherWaitsForTooNeedNotWaitBehindItsOwnersLongJobs) {
  for (const Nanoseconds joined_after : {1 * ms, 900 * ms}) {
    Play play(2);
    for (int i = 0; i < 3; ++i) play.come(endless, ms, 64, 1);
    play.run(play.now() + 6000 * ms);
    Play::Job& shared = play.come(3000, ms, 64, 1);
    play.run(play.now() + joined_after);
    play.join(shared, 2);
    const Nanoseconds then = play.now();
    play.finish(shared);
    // Half of two threads, from when it is his at the latest.
    EXPECT_LT(play.now() - then, 3300 * ms) << joined_after;
  }
}

// Joining takes nothing from him who began it: it stays his where his turn comes sooner.
TEST(Turns, WhoJoinsDoesNotDrawWorkBehindHisOwn) {
  Play play(2);
  for (int i = 0; i < 3; ++i) play.come(endless, ms, 64, 1);
  play.run(play.now() + 6000 * ms);
  Play::Job& shared = play.come(3000, ms, 64, 2);
  play.run(play.now() + 900 * ms);
  play.join(shared, 1);
  const Nanoseconds then = play.now();
  play.finish(shared);
  EXPECT_LT(play.now() - then, 3300 * ms);
}

TEST(Turns, ManyJobsOfOneClientTakeNoMoreThanTheOneOfAnother) {
  Play play(2);
  const Play::Job& one = play.come(endless, ms, 64, 1);
  for (int i = 0; i < 16; ++i) play.come(endless, ms, 64, 2);
  const Nanoseconds start = play.now();
  play.run(start + 10'000 * ms);
  const double even = 10'000.0 * ms, ahead = 4.0 * Turns::credit;
  EXPECT_NEAR(static_cast<double>(one.had), even, ahead);
}

TEST(Turns, WhoAsksForOneThingAfterTheOtherHardlyNoticesAFlood) {
  // Sixteen who come again and again, and one whose jobs take 16 ms of each thread, every 20 ms.
  Play play(2);
  for (int i = 0; i < 16; ++i) play.come(20, ms, 64, 2);
  const Nanoseconds start = play.now(), end = start + 10'000 * ms;
  const Play::Job* dragged = &play.come(32, ms, 64, 1);
  int drawn = 0;
  Nanoseconds pause = 0;
  while (play.now() < end) {
    const Play::Job* over = play.run(dragged != nullptr ? end : std::min(end, pause));
    if (over == dragged && dragged != nullptr) {
      ++drawn;
      dragged = nullptr;
      pause = play.now() + 4 * ms;
    } else if (over != nullptr) {
      play.come(20, ms, 64, 2);
    }
    if (dragged == nullptr && play.now() >= pause) dragged = &play.come(32, ms, 64, 1);
  }
  EXPECT_GE(drawn, 500 * 8 / 10);
}

// Tasks during which nobody looks for others, each of a new job: the place of the one who looks
// must not be what they take again and again.
TEST(Turns, LongTasksOfAClientThatAsksAgainLeaveAnotherAQuarterOfAnEvenShare) {
  for (const int at_once : {2, 4, 8}) {
    Play play(2);
    const Play::Job& victim = play.come(endless, ms, 64, 1);
    for (int i = 0; i < at_once; ++i) play.come(1, 750 * ms, 64, 2);
    const Nanoseconds start = play.now(), time = 60'000 * ms;
    while (play.run(start + time) != nullptr) play.come(1, 750 * ms, 64, 2);
    EXPECT_GE(victim.had, time / 4) << at_once;
  }
}

// Whether it is one large job, or many small ones, each new where the last one has ended.
TEST(Turns, TheBackgroundHasTheLeastShareHoweverItIsCut) {
  constexpr double cost = Turns::background_cost;
  for (const int clients : {0, 1, 3})
    for (const int tasks : {endless, 100, 10}) {
      Play play(2);
      play.come(tasks, ms, 64, 9, true);
      for (int i = 0; i < clients; ++i) play.come(endless, ms, 64, std::uint64_t(i));
      const Nanoseconds start = play.now(), time = 20'000 * ms;
      Nanoseconds had = 0;
      while (const Play::Job* over = play.run(start + time)) {
        had += over->had;
        play.come(tasks, ms, 64, 9, true);
      }
      for (const Play::Job& job : play.all())
        if (job.own.is_background && !job.is_over()) had += job.had;
      const double share = static_cast<double>(had) / (2 * static_cast<double>(time));
      EXPECT_NEAR(share, 1 / (1 + cost * clients), 0.01) << clients << ", " << tasks;
    }
}

// What comes again and again, each time new, finds both threads at it, and does not stop it: of two
// clients the level rises by an eighth of all service, and the background's counts several times.
TEST(Turns, SmallJobsHardlyNoticeTheBackgroundWhichGoesOnBesideThem) {
  Play play(2);
  const Play::Job& background = play.come(endless, ms / 4, 64, 9, true);
  play.run(play.now() + 1000 * ms);
  const Nanoseconds before = background.had, start = play.now();
  int drawn = 0;
  for (; play.now() < start + 10'000 * ms; ++drawn) play.finish(play.come(20, ms, 64, 1));
  EXPECT_GE(drawn, 1000 * 9 / 10 - 10);
  EXPECT_GE(background.had - before, 20'000 * ms / (4 * 2 * Turns::background_cost));
}

TEST(Turns, AStreamOfOneClientLeavesTheOthersAQuarterOfAnEvenShare) {
  Play play(2);
  const Play::Job& big = play.come(endless, ms, 64, 1);
  play.run(play.now() + 1000 * ms);
  const Nanoseconds before = big.had, start = play.now();
  play.come(10, ms, 64, 2);
  while (play.now() < start + 10'000 * ms)
    if (play.run(start + 10'000 * ms) != nullptr) play.come(10, ms, 64, 2);
  EXPECT_GE(big.had - before, 20'000 * ms / 8 - 2 * Turns::credit);
}

}  // namespace
}  // namespace tia
