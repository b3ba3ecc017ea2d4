// Hands: the threads that work at jobs, and which job each of them is at. A pool is how they are
// used.
#pragma once

#include <algorithm>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <list>
#include <mutex>
#include <stop_token>
#include <thread>
#include <vector>

#include "core/parallel/stopped.h"
#include "core/parallel/task_context.h"
#include "core/parallel/turns.h"

namespace tia {

class Hands;
struct Job;

/// Hand: a thread that can work: a worker, or a caller, which has but its own job.
/// Within a task it lets jobs go first that have had less: it is suspended, and the task with it.
struct Hand : Courtesy {
  Hand(Hands& of, bool caller) : hands(of), is_caller(caller) {}
  void let_others_go() override;

  Hands& hands;
  const bool is_caller;
  Job* job = nullptr;              ///< where it works, or is called to while it sleeps
  Nanoseconds since = 0;           ///< when it began what has not been told to the turns
  Hand* next_suspended = nullptr;  ///< of its job
  std::condition_variable_any called{};
};

/// Job: what a caller wants done, and who is at it.
struct Job : Turn {
  Job(Hands& all, int tasks, int most, const std::stop_token& asked,
      const std::function<void(int)>& what, Flow& request, bool alone = false)
      : Turn(tasks, most, request), is_alone(alone), stop(asked), task(what), caller(all, true) {}

  const bool is_alone;  ///< only its caller can do it
  const std::stop_token& stop;
  const std::function<void(int)>& task;
  void* const context = task_context;    ///< the caller's
  std::exception_ptr failure = nullptr;  ///< guarded by the hands' mutex, as is what a turn counts
  Hand* suspended_hands = nullptr;       ///< the last one first
  Hand caller;

  /// Has the hand take tasks until it is time to look for others. Returns: what a task threw.
  std::exception_ptr run(Hand& hand);

 private:
  void run_tasks(const Hand& hand);
};

/// Hands. Any thread may call. The workers are one less than the threads; for each that is
/// suspended another one is made, which stays.
class Hands {
 public:
  using Clock = std::function<Nanoseconds()>;
  /// Workers that may be suspended at once, of so many threads: each keeps its stack. The parked
  /// pictures of one client hold them: beyond these a task goes on to its end.
  static int most_suspended(int threads) {
    return threads > 1 ? std::min(8 * threads, 64) : 0;  // the only thread is the caller's
  }

  Hands(int threads, Clock clock);
  ~Hands();
  Hands(const Hands&) = delete;
  Hands& operator=(const Hands&) = delete;

  int threads() const { return turns_.threads(); }
  /// Whether this thread is within a task or lone work.
  static bool is_inside_task();

  /// Does all of the job, its caller too, which this thread is. Errors: Stopped; what a task
  /// throws.
  void share(Job& job);

  // Of work that only its caller does, in its own time: enter, begin, end ..., leave.
  void enter(Job& job);
  void leave(Job& job);
  void begin_alone(Job& job);  ///< when it is its turn. Errors: Stopped
  void end_alone(Job& job);
  void pause(Job& job);  ///< Domain: it has ended. It wants no hand, until resume()
  void resume(Job& job);

  /// That the flow's work is for this client, too (Turns::also_for).
  void also_for(Flow& flow, std::uint64_t client);
  Nanoseconds now() const { return clock_(); }

 private:
  friend Hand;
  bool add_worker();
  void serve(Hand& hand, const std::stop_token& ending);
  void work(Hand& hand, std::unique_lock<std::mutex>& lock);
  void begin(Hand& hand);
  void tell(Hand& hand);
  void let_others_go(Hand& hand);
  bool may_suspend(const Hand& hand);
  void suspend(Hand& hand, Job& job);
  void restore(Hand& hand, Job& job);
  template <class News>
  void wait(Hand& hand, std::unique_lock<std::mutex>& lock, const std::stop_token& stop,
            const News& news);
  template <class Can>
  Job* next_job(const Can& can) const;
  void seat(Hand& hand, Job& job);
  void unseat(Hand& hand);
  void dismiss_idle(const Job& job);
  void call_hands();
  Hand* hand_for(Job& job) const;

  const Clock clock_;
  std::mutex mutex_;  // of all below
  Turns turns_;
  int suspended_ = 0;        // workers
  std::vector<Hand*> idle_;  // workers that sleep, some of them called to a job already
  std::list<Hand> hands_;    // the workers', made before them, for making one may fail
  std::list<std::jthread> workers_;
};

}  // namespace tia
