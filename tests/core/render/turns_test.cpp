// The laws of sharing, on processors and times that are played.
#include "core/render/turns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <list>
#include <memory>
#include <vector>

#include "tests/core/render/jobs.h"

namespace tia {
namespace {

using test::endless;
using test::ms;

/// Jobs whose tasks take as long as they say, on hands that are at once where they are called.
class Play {
 public:
  struct Job : Turn {
    Job(int tasks, int most, Nanoseconds each) : Turn(tasks, most), cost(each) {}
    const Nanoseconds cost;
    Nanoseconds came = 0, had = 0;
  };

  explicit Play(int threads) : turns_(threads) {}
  Nanoseconds now() const { return now_; }
  std::size_t most_at_once() const { return most_at_once_; }

  Job& come(int tasks, Nanoseconds cost, int most = 64) {
    Job& job = jobs_.emplace_back(tasks, most, cost);
    job.came = now_;
    turns_.enter(job, now_);
    call();
    return job;
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
    turns_.spend(job.cost);
    job.had += job.cost;
    if (turns_.stays(job, now_)) {
      take(*hand);
      return nullptr;
    }
    Turns::end(job, now_);
    turns_.dismiss(job);
    hands_.erase(hand);
    if (job.is_over()) turns_.leave(job);
    call();
    return job.is_over() ? &job : nullptr;
  }
  void call() {
    while (Turn* turn = turns_.next(now_)) {
      turns_.call(*turn);
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

TEST(Turns, EqualJobsShareTheTimeHoweverLongTheirTasks) {
  for (const int threads : {1, 2, 5}) {
    for (const Nanoseconds cost : {ms / 4, ms, 30 * ms}) {
      Play play(threads);
      const Play::Job &a = play.come(endless, ms), &b = play.come(endless, cost);
      for (int i = 0; i < 100; ++i) {
        play.run(play.now() + 100 * ms);
        EXPECT_LE(std::abs(a.had - b.had), Turns::slice + threads * (cost + ms))
            << threads << ", " << cost;
      }
    }
  }
}

TEST(Turns, LaterJobIsAheadByItsCreditAndThenEven) {
  Play play(2);
  const Play::Job& first = play.come(endless, ms);
  play.run(play.now() + 5000 * ms);
  const Nanoseconds before = first.had;
  const Play::Job& second = play.come(endless, ms);
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
  // One job on a single thread falls behind another on fifteen. A third one comes: it begins near
  // the first, but must not keep the second waiting until all that is made up for.
  Play play(16);
  const Play::Job& narrow = play.come(endless, ms, 1);
  const Play::Job& wide = play.come(endless, ms);
  play.run(play.now() + 60'000 * ms);
  EXPECT_GT(wide.had, 10 * narrow.had);
  const Nanoseconds before = wide.had;
  const Play::Job& third = play.come(endless, ms);
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

}  // namespace
}  // namespace tia
