// Pool: the one warm set of threads that all renders share fairly. A caller works on its own job,
// too. Time decides who works next, never what comes out.
#pragma once

#include <functional>
#include <list>
#include <mutex>
#include <stop_token>
#include <thread>
#include <vector>

#include "core/parallel/turns.h"
#include "core/parallel/workers.h"

namespace tia {

/// Pool: threads that work at jobs by turns.
class Pool {
 public:
  using Clock = std::function<Nanoseconds()>;

  /// A pool whose jobs run on up to `threads` threads, the callers' included. Domain: >= 1.
  explicit Pool(int threads, Clock clock = steady_clock);
  ~Pool();
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;

  int threads() const { return turns_.threads(); }

  /// Calls task(0) … task(count - 1), each once, in no order, on at most `max_threads` threads;
  /// inside of another task in turn, on the thread of that one; inside of lone work with all
  /// threads, as that work's next job. `flow` is the request that it belongs to; null: one of its
  /// own. Tasks find the caller's task_context, and give way at each end_if_asked() to jobs that
  /// have had less: they hold nothing meanwhile that others wait for.
  /// Errors: Stopped between tasks once `stop` is requested; whatever a task throws.
  void for_each(int count, int max_threads, const std::stop_token& stop,
                const std::function<void(int)>& task, Flow* flow = nullptr);
  /// Does work that cannot be shared, on the caller's thread: when it is its turn, and giving way
  /// at each end_if_asked() to jobs that have had less. Inside of a task at once. Domain: it waits
  /// for nothing else meanwhile. Errors: Stopped; whatever it throws.
  void alone(const std::function<void()>& work, const std::stop_token& stop, Flow* flow = nullptr);
  /// Those threads as workers, who end once `stop` is requested. Domain: pool and flow outlive
  /// them.
  Workers workers(int max_threads, const std::stop_token& stop = {}, Flow* flow = nullptr);

 private:
  struct Job;
  struct Hand;
  class Lone;
  static Nanoseconds steady_clock();
  static thread_local Lone* lone;  // whose work this thread does

  void serve(Hand& hand, const std::stop_token& ending);
  void work(Hand& hand, std::unique_lock<std::mutex>& lock);
  void begin(Hand& hand);
  void tell(Hand& hand);
  void let_others_go(Hand& hand);
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
  int may_suspend_;          // workers, besides those that are
  std::vector<Hand*> idle_;  // workers that sleep, some of them called to a job already
  std::list<Hand> hands_;    // the workers', made before them, for making one may fail
  std::vector<std::jthread> workers_;
};

}  // namespace tia
