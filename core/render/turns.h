// Turns: which job a free thread goes to, so that jobs share threads fairly. Plain bookkeeping: it
// starts no thread, locks nothing and is told the time.
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

namespace tia {

using Nanoseconds = std::int64_t;

/// Turn: a job as seen from outside. Hands are the threads at it.
struct Turn {
  Turn(int tasks, int most) : count(tasks), most_hands(most) {}

  const int count, most_hands;
  std::atomic<int> next = 0;  ///< the task to be taken next
  int hands = 0;              ///< called to it
  int awake = 0;              ///< of those, at work
  Nanoseconds before = 0;     ///< the service that those found, less the times at which they came
  Nanoseconds young = 0;      ///< the service up to which it is within its credit

  bool has_tasks() const { return next.load(std::memory_order_relaxed) < count; }
  bool wants_hand() const { return has_tasks() && hands < most_hands; }
  bool is_over() const { return hands == 0 && !has_tasks(); }
  Nanoseconds service(Nanoseconds now) const { return before + awake * now; }
  bool is_young(Nanoseconds now) const { return service(now) < young; }
};

/// Turns. "Least attained service first": a thread that is free goes to the job that has had the
/// least service, the time that threads spent on it. So a small job overtakes a big one.
/// Bounds: a thread leaves its job for one that has had less by more than `slice`; it looks for
/// such a one between tasks, every `look`.
/// A new job begins `credit` below the least of the others: so much it may have before them. An
/// endless stream of new jobs starves nobody: with n jobs present, the level that they begin below
/// rises by at least 1/2n of all service, so each job gets half of an even share or more.
/// No job is owed more than `arrears` when another begins: few threads save up no claim to all.
/// At most `threads` hands at once, and one more at times: a young job, still within its credit,
/// that has no hand does not wait for the end of an older one's task; the next hand of an old job
/// to end one leaves.
/// Source: Kleinrock, "Queueing Systems" vol. 2 (1976), ch. 4 (foreground-background); the start of
/// new jobs after Goyal, Vin, Cheng, "Start-time fair queueing" (1996).
class Turns {
 public:
  static constexpr Nanoseconds look = 250'000, slice = 2'000'000, credit = 50'000'000,
                               arrears = 1'000'000'000;

  explicit Turns(int threads) : threads_(threads) {}
  int threads() const { return threads_; }

  void enter(Turn& job, Nanoseconds now);
  void leave(const Turn& job);
  /// Returns: the job that one more hand should go to, or null.
  Turn* next(Nanoseconds now) const;
  /// Whether a hand goes on with its job.
  bool stays(const Turn& job, Nanoseconds now) const;

  void call(Turn& job);     ///< a hand to it
  void dismiss(Turn& job);  ///< a hand that is not at work
  static void begin(Turn& job, Nanoseconds now);
  static void end(Turn& job, Nanoseconds now);
  /// That a hand was at work for so long.
  void spend(Nanoseconds time);

 private:
  const int threads_;
  std::vector<Turn*> jobs_;
  int hands_ = 0;          // of all jobs
  Nanoseconds level_ = 0;  // the service that makes a job even with the others
};

}  // namespace tia
