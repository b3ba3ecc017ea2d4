// Pool: the one warm set of threads that all renders share fairly. A caller works on its own job,
// too. Time decides here who works next, never what comes out.
#pragma once

#include <cstdint>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>
#include <vector>

#include "core/input/stopped.h"

namespace tia {

/// Pool. "Least attained service first": a thread that is free goes to the job that has had the
/// least service, the time that threads spent on it. So a small job overtakes a big one.
/// Bounds: a thread looks for such a job between tasks, every `look`, and leaves its own for one
/// that has had less by more than `slice`.
/// A new job begins `credit` below the least of the others: so much it may have before them. An
/// endless stream of new jobs starves nobody: with n jobs present, what a job must have had to be
/// level rises by at least 1/2n of all service, so each gets half of an even share or more.
/// No job is ever owed more than `arrears`: one on few threads saves up no claim to all.
/// At most `threads` threads work at once, and one more at times: a job still within its credit
/// does not wait for the end of an older job's task; the older one's next thread to end one leaves.
/// Source: Kleinrock, "Queueing Systems" vol. 2 (1976), 4.6 (foreground-background); the start of
/// new jobs after Goyal, Vin, Cheng, "Start-time fair queueing" (1996).
class Pool {
 public:
  using Nanoseconds = std::int64_t;
  using Clock = std::function<Nanoseconds()>;
  static constexpr Nanoseconds look = 250'000, slice = 2'000'000, credit = 50'000'000,
                               arrears = 1'000'000'000;

  /// A pool whose jobs run on up to `threads` threads, the callers' included. Domain: >= 1.
  explicit Pool(int threads, Clock clock = steady_clock);
  ~Pool();
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;

  int threads() const { return threads_; }

  /// Calls task(0) … task(count - 1), each once, in no order, on at most `max_threads` threads;
  /// inside of another task in turn, on the thread of that one.
  /// Errors: Stopped between tasks once `stop` is requested; whatever a task throws.
  void for_each(int count, int max_threads, const std::stop_token& stop,
                const std::function<void(int)>& task);

 private:
  struct Job;
  struct Hand;
  static Nanoseconds steady_clock();

  void serve(const std::stop_token& ending);
  void work(Hand& hand, std::unique_lock<std::mutex>& lock);
  void enter(Job& job);
  Job* next_job(Nanoseconds now) const;
  bool stays(const Job& job, Nanoseconds now) const;
  void seat(Hand& hand, Job& job);
  void unseat(Hand& hand);
  void dismiss_idle(const Job& job);
  void call_hands();

  const int threads_;
  const Clock clock_;
  std::mutex mutex_;  // of all below
  std::vector<Job*> jobs_;
  std::vector<Hand*> idle_;  // workers that sleep, some of them called to a job already
  int at_work_ = 0;          // hands that have a job
  Nanoseconds level_ = 0;    // what a job must have had to be even with the others
  std::vector<std::jthread> workers_;
};

}  // namespace tia
