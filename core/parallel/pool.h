// Pool: the one warm set of threads that all renders share fairly. A caller works on its own job,
// too. Time decides who works next, never what comes out.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>

#include "core/parallel/turns.h"
#include "core/parallel/workers.h"

namespace tia {

class Hands;

/// Pool: threads that work at jobs by turns.
class Pool {
 public:
  using Clock = std::function<Nanoseconds()>;

  /// A pool whose jobs run on up to `threads` threads, the callers' included. Domain: >= 1. Without
  /// a clock it has the steady one.
  /// Errors: std::system_error where so many cannot be.
  explicit Pool(int threads, Clock clock = {});
  ~Pool();

  int threads() const;
  /// The most threads that it may yet make, where tasks are suspended.
  int most_more_threads() const;

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
  /// That another client waits for the flow's work, too: it takes its turns where it is sooner.
  void also_for(Flow& flow, std::uint64_t client);

 private:
  const std::unique_ptr<Hands> hands_;
};

}  // namespace tia
