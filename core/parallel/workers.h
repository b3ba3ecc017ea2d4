// Workers: who shares the work of a call, and until when.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <stop_token>
#include <utility>

#include "core/parallel/stopped.h"

namespace tia {

/// Workers: by themselves the caller, who does all; else threads of whoever gives them.
class Workers {
 public:
  using Task = std::function<void(int)>;
  using ForEach = std::function<void(int count, const Task& task)>;
  using Alone = std::function<void(const std::function<void()>& work)>;

  /// The caller alone, until `stop` is requested.
  Workers(std::stop_token stop = {}) : stop_(std::move(stop)) {}
  /// `for_each` calls task(0) … task(count - 1), each once, in any order, several at a time, and
  /// returns when all are done; `alone` calls work() when it is the caller's turn.
  explicit Workers(ForEach for_each, Alone alone = {}, std::stop_token stop = {})
      : for_each_(std::move(for_each)), alone_(std::move(alone)), stop_(std::move(stop)) {}

  /// Errors: what a task or for_each throws; Stopped between tasks once that is asked for.
  void for_each(int count, const Task& task) const {
    if (for_each_ && count > 1) return for_each_(count, task);
    for (int i = 0; i < count; ++i) {
      end_if_asked();
      task(i);
    }
  }
  /// Calls work(from, to) for shares of what is numbered from 0 to count - 1, as many whoever
  /// works.
  void for_each_share(std::size_t count,
                      const std::function<void(std::size_t, std::size_t)>& work) const {
    constexpr std::size_t share = 1 << 15;
    for_each(static_cast<int>((count + share - 1) / share), [&](int i) {
      const std::size_t from = static_cast<std::size_t>(i) * share;
      work(from, std::min(from + share, count));
    });
  }
  /// Calls work(), which is not shared but where it calls for_each, when it is the caller's turn.
  /// Domain: it waits for nothing else. Errors: Stopped; what work throws.
  void alone(const std::function<void()>& work) const {
    if (alone_) alone_(work);
    else work();
  }
  /// Errors: Stopped once that is asked for.
  void end_if_asked() const { tia::end_if_asked(stop_); }
  const std::stop_token& stop() const { return stop_; }

 private:
  ForEach for_each_;
  Alone alone_;
  std::stop_token stop_;
};

}  // namespace tia
