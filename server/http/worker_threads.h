// The threads that make answers.
#pragma once

#include <asio/executor_work_guard.hpp>
#include <asio/io_context.hpp>
#include <asio/post.hpp>
#include <thread>
#include <utility>
#include <vector>

namespace tia::server {

/// WorkerThreads: as many threads as may wait or work at once. As asio::thread_pool, but for this:
/// where the system has no thread more to give, its making ends, with those that there are.
class WorkerThreads {
 public:
  /// Errors: std::system_error.
  explicit WorkerThreads(int count) {
    threads_.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) threads_.emplace_back([this] { jobs_.run(); });
  }
  /// Has one of them do it. Errors: std::bad_alloc.
  template <class Job>
  void post(Job job) {
    asio::post(jobs_, std::move(job));
  }
  /// Waits until all has been done. Nothing may be posted from then on.
  void join() {
    more_.reset();
    threads_.clear();
  }

 private:
  asio::io_context jobs_;
  std::vector<std::jthread> threads_;
  asio::executor_work_guard<asio::io_context::executor_type> more_{jobs_.get_executor()};
};

}  // namespace tia::server
