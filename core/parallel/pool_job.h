// The parts of a pool that only itself sees: its hands and the jobs that they work at.
#pragma once

#include <atomic>
#include <condition_variable>
#include <exception>
#include <utility>

#include "core/parallel/pool.h"
#include "core/parallel/task_context.h"

namespace tia {

/// Whether this thread is within a task or lone work.
constinit inline thread_local bool inside_task = false;

/// Hand: a thread that can work: one of the pool's own, or a caller, which has but its own job.
/// Within a task it lets jobs go first that have had less: it is suspended, and the task with it.
struct Pool::Hand : Courtesy {
  Hand(Pool& of, bool caller) : pool(of), is_caller(caller) {}
  void let_others_go() override { pool.let_others_go(*this); }

  Pool& pool;
  const bool is_caller;
  Job* job = nullptr;              // where it works, or is called to while it sleeps
  Nanoseconds since = 0;           // when it began what has not been told to the turns
  Hand* next_suspended = nullptr;  // of its job
  std::condition_variable_any called;
};

/// Job: what a caller wants done, and who is at it.
struct Pool::Job : Turn {
  Job(Pool& pool, int tasks, int most, const std::stop_token& asked,
      const std::function<void(int)>& what, Flow& request, bool alone = false)
      : Turn(tasks, most, request), is_alone(alone), stop(asked), task(what), caller(pool, true) {}

  const bool is_alone;  // only its caller can do it

  const std::stop_token& stop;
  const std::function<void(int)>& task;
  void* const context = task_context;    // the caller's
  std::exception_ptr failure = nullptr;  // guarded by the pool's mutex, as is what a turn counts
  Hand* suspended_hands = nullptr;       // the last one first
  Hand caller;

  // Has the hand take tasks until it is time to look for others. Returns: what a task threw.
  std::exception_ptr run(Hand& hand) {
    inside_task = true;
    courtesy = &hand;
    void* const outside = std::exchange(task_context, context);
    std::exception_ptr thrown = nullptr;
    try {
      run_tasks(hand);
    } catch (...) {
      next = count;
      thrown = std::current_exception();
    }
    task_context = outside;
    courtesy = nullptr;
    inside_task = false;
    return thrown;
  }
  void run_tasks(const Hand& hand) {
    do {
      if (stop.stop_requested()) next = count;
      const int i = next.fetch_add(1, std::memory_order_relaxed);
      if (i >= count) return;
      task(i);
    } while (hand.pool.clock_() < hand.since + Turns::look);
  }
};

}  // namespace tia
