// Pool: the one warm set of threads that all renders share. A caller works on its own job too.
#pragma once

#include <condition_variable>
#include <functional>
#include <list>
#include <mutex>
#include <stop_token>
#include <thread>
#include <vector>

namespace tia {

/// Stopped: the render was told to stop; no picture.
class Stopped : public std::exception {
 public:
  const char* what() const noexcept override { return "stopped"; }
};

class Pool {
 public:
  /// A pool whose jobs run on up to `threads` threads, the caller's included. Domain: >= 1.
  explicit Pool(int threads);
  ~Pool();
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;

  int threads() const { return static_cast<int>(workers_.size()) + 1; }

  /// Calls task(0) … task(count - 1), each once, in no order, on at most `max_threads` threads.
  /// Errors: Stopped between tasks once `stop` is requested; whatever a task throws.
  void for_each(int count, int max_threads, const std::stop_token& stop,
                const std::function<void(int)>& task);

 private:
  struct Job;
  void serve(const std::stop_token& ending);

  std::mutex mutex_;
  std::condition_variable_any wanted_;  // a job wants helpers
  std::condition_variable done_;        // a helper left its job
  std::list<Job*> jobs_;
  std::vector<std::jthread> workers_;
};

}  // namespace tia
