#include "server/operation/shared_flow.h"

#include "server/operation/requester.h"

namespace tia::server {

void SharedFlow::also_for(const std::string& client) {
  place.also_for(client);
  const std::lock_guard lock(mutex_);
  const std::uint64_t number = Requester{client, {}}.number();
  others_.insert(number);
  if (flow_ != nullptr) pool_.also_for(*flow_, number);
}

void SharedFlow::set(Flow* flow) {
  const std::lock_guard lock(mutex_);
  flow_ = flow;
  if (flow != nullptr) flow->others.assign(others_.begin(), others_.end());
}

}  // namespace tia::server
