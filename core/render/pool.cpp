#include "core/render/pool.h"

#include <algorithm>
#include <atomic>
#include <exception>

namespace tia {

struct Pool::Job {
  int count;
  const std::stop_token& stop;
  const std::function<void(int)>& task;
  std::atomic<int> next = 0;
  int helpers_wanted;  // guarded by the pool's mutex, as is all below
  int helpers_at_work = 0;
  std::exception_ptr failure = nullptr;

  // Takes tasks until none is left. Returns what a task threw.
  std::exception_ptr work() {
    try {
      while (!stop.stop_requested()) {
        const int i = next.fetch_add(1, std::memory_order_relaxed);
        if (i >= count) break;
        task(i);
      }
    } catch (...) {
      next = count;
      return std::current_exception();
    }
    return nullptr;
  }
};

Pool::Pool(int threads) {
  for (int i = 1; i < threads; ++i)
    workers_.emplace_back([this](const std::stop_token& ending) { serve(ending); });
}

Pool::~Pool() {
  for (std::jthread& worker : workers_) worker.request_stop();
}

void Pool::serve(const std::stop_token& ending) {
  std::unique_lock lock(mutex_);
  const auto wants_help = [](const Job* job) { return job->helpers_wanted > 0; };
  for (;;) {
    const bool found = wanted_.wait(
        lock, ending, [&] { return std::any_of(jobs_.begin(), jobs_.end(), wants_help); });
    if (!found) return;
    Job& job = **std::find_if(jobs_.begin(), jobs_.end(), wants_help);
    --job.helpers_wanted;
    ++job.helpers_at_work;
    lock.unlock();
    const std::exception_ptr failure = job.work();
    lock.lock();
    if (failure && !job.failure) job.failure = failure;
    --job.helpers_at_work;
    done_.notify_all();
  }
}

void Pool::for_each(int count, int max_threads, const std::stop_token& stop,
                    const std::function<void(int)>& task) {
  const int helpers = std::min({max_threads, threads(), count}) - 1;
  Job job{.count = count, .stop = stop, .task = task, .helpers_wanted = helpers};
  std::list<Job*> mine{&job};
  if (helpers > 0) {
    const std::lock_guard lock(mutex_);
    jobs_.splice(jobs_.end(), mine);
    wanted_.notify_all();
  }
  std::exception_ptr failure = job.work();
  if (helpers > 0) {
    std::unique_lock lock(mutex_);
    jobs_.remove(&job);
    done_.wait(lock, [&] { return job.helpers_at_work == 0; });
    if (!failure) failure = job.failure;
  }
  if (failure) std::rethrow_exception(failure);
  if (stop.stop_requested()) throw Stopped();
}

}  // namespace tia
