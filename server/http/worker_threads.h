// The threads that make answers.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace tia::server {

/// WorkerThreads: as many threads as may wait or work at once. Jobs go in order; who rested last
/// takes the next one: so few threads do what few can, and the others touch no memory.
class WorkerThreads {
 public:
  /// Errors: std::system_error, with no thread left, where the system has none more to give.
  explicit WorkerThreads(int count) {
    resting_.reserve(static_cast<std::size_t>(count));
    threads_.reserve(static_cast<std::size_t>(count));
    try {
      for (int i = 0; i < count; ++i) threads_.emplace_back([this] { work(); });
    } catch (...) {
      join();
      throw;
    }
  }
  ~WorkerThreads() { join(); }
  WorkerThreads(const WorkerThreads&) = delete;
  WorkerThreads& operator=(const WorkerThreads&) = delete;

  /// Has one of them do it. Errors: std::bad_alloc.
  void post(std::function<void()> job) {
    const std::lock_guard lock(mutex_);
    jobs_.push_back(std::move(job));
    if (resting_.empty()) return;
    resting_.back()->is_called = true;
    resting_.back()->call.notify_one();
    resting_.pop_back();
  }
  /// Waits until all has been done. Nothing may be posted from then on.
  void join() {
    {
      const std::lock_guard lock(mutex_);
      is_over_ = true;
      for (Rest* rest : resting_) rest->call.notify_one();
      resting_.clear();  // they end with their threads
    }
    threads_.clear();
  }

 private:
  /// Rest: of one thread, until it is called.
  struct Rest {
    std::condition_variable call;
    bool is_called = false;
  };

  void work() {
    Rest rest;
    std::unique_lock lock(mutex_);
    for (;;) {
      while (!jobs_.empty()) {
        std::function<void()> job = std::move(jobs_.front());
        jobs_.pop_front();
        lock.unlock();
        job();
        job = nullptr;
        lock.lock();
      }
      if (is_over_) return;
      rest.is_called = false;
      resting_.push_back(&rest);
      rest.call.wait(lock, [&] { return rest.is_called || is_over_; });
    }
  }

  std::mutex mutex_;
  std::deque<std::function<void()>> jobs_;
  std::vector<Rest*> resting_;  // with room for all
  bool is_over_ = false;
  std::vector<std::jthread> threads_;
};

}  // namespace tia::server
