// Jobs: the store, who draws, and who watches, as one.
#pragma once

#include <memory>
#include <mutex>

#include "server/access/access.h"
#include "server/jobs/board.h"
#include "server/jobs/runner.h"
#include "server/operation/config.h"

namespace tia::server {

class Jobs {
 public:
  /// All that is given outlives it.
  Jobs(std::unique_ptr<JobStore> store, const Config& config, const RenderContext& context,
       CostMemory& costs, PictureStore& pictures, Access& access, Metrics& metrics,
       MemoryAccount& memory);

  ~Jobs();
  Jobs(const Jobs&) = delete;
  Jobs& operator=(const Jobs&) = delete;

  JobStore& store() { return *store_; }
  const JobHost& host() const { return host_; }
  /// For tests: smaller windows than about a second's work.
  void cut_to(int window_px) { host_.window_px = window_px; }
  Board& board() { return board_; }
  /// Begins to draw what is there; nothing draws before.
  void start();
  /// Parts that may be drawn at once.
  int workers() const { return at_once_; }

 private:
  void has_changed(const std::string& id);

  const std::unique_ptr<JobStore> store_;
  const Elsewhere elsewhere_ = [this](const std::string& name) { return store_->lent(name); };
  JobHost host_;
  MemoryAccount& memory_;
  const int at_once_;
  Board board_;
  const Workplace workplace_;
  std::mutex mutex_;
  std::int64_t booked_ = 0;         // of the account, for a store in memory
  std::unique_ptr<Runner> runner_;  // from the first job on
};

/// What a store may hold, by the options; one in memory an eighth of that at most.
JobLimits job_limits(const Config& config, bool is_durable);
/// The store of the folder of kept things; or in memory, where there is none, or another process
/// has it, which is logged.
/// Errors: std::runtime_error.
std::unique_ptr<JobStore> job_store(const Config& config);
std::unique_ptr<JobStore> job_store_in_memory(const Config& config);

}  // namespace tia::server
