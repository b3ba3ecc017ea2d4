// Who draws the parts of jobs in this process.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "server/jobs/drawing.h"

namespace tia::server {

/// Runner: a few threads that claim parts, draw them by the pool's threads and hand in what came of
/// them. Parts take no ticket of those that requests wait for: who asks for a picture waits for
/// none of them.
class Runner {
 public:
  /// As many parts as `at_once` may be under way.
  Runner(const Workplace& at, int at_once);
  ~Runner();

  /// Ends, and gives back what is under way.
  void stop();

  /// Something of a job has changed: there may be more to do, or less.
  void look_again(const std::string& id);

  static TimeMs now();

 private:
  /// Running: a part that is being drawn.
  struct Running {
    Claim claim;
    std::stop_source stop;
  };
  /// Opened: a job whose parts are known.
  struct Opened {
    std::string id, version;
    std::shared_ptr<const JobParts> parts;
  };

  void work(const std::stop_token& ending);
  bool work_once(const std::stop_token& ending);
  void wait(const std::stop_token& ending);
  void draw(const Claim& claim, const std::stop_token& ending);
  void draw_claimed(const Claim& claim, const std::stop_token& stop);
  void check_kept(Job job, std::size_t bytes) const;
  void give_up(const Claim& claim, const std::exception_ptr& failure);
  std::shared_ptr<const JobParts> parts_of(const Job& job);
  void plan_anew();
  void keep_order();

  const Workplace at_;
  std::mutex mutex_;
  std::condition_variable_any news_;
  std::uint64_t told_ = 0;  // how often there was news
  std::list<Running> running_;
  std::list<Opened> opened_;  // the newest first
  TimeMs swept_ = 0;
  std::vector<std::jthread> threads_;
};

}  // namespace tia::server
