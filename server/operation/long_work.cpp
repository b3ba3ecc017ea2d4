#include "server/operation/long_work.h"

#include "server/operation/memory_account.h"

namespace tia::server {

void LongWork::run(const Need& need, const Requester& requester,
                   const std::function<void()>& work) {
  const auto ticket = admission_.read(need.bytes, requester.client, requester.stop);
  reserve_memory(need.memory, need.what, requester.stop);
  Flow flow{requester.number()};
  pool_.alone(work, requester.stop, &flow);
  settle_memory();
}

}  // namespace tia::server
