// SharedFlow: one request's work, whose turns may be taken for others who wait for the same.
#pragma once

#include <cstdint>
#include <mutex>
#include <set>
#include <string>

#include "core/parallel/pool.h"
#include "server/operation/admission.h"

namespace tia::server {

/// SharedFlow: from the request's coming to its end. Any thread may call.
class SharedFlow {
 public:
  explicit SharedFlow(Pool& pool) : pool_(pool) {}

  /// That this client waits for the work, too: before it has a ticket, and after.
  void also_for(const std::string& client);

  /// Going: while it is worked at, in that flow.
  class Going {
   public:
    Going(SharedFlow& shared, Flow& flow) : shared_(shared) { shared_.set(&flow); }
    ~Going() { shared_.set(nullptr); }
    Going(const Going&) = delete;
    Going& operator=(const Going&) = delete;

   private:
    SharedFlow& shared_;
  };

  Admission::Waiting place{};  ///< where it waits for its ticket

 private:
  void set(Flow* flow);

  Pool& pool_;
  std::mutex mutex_;
  Flow* flow_ = nullptr;
  std::set<std::uint64_t> others_;
};

}  // namespace tia::server
