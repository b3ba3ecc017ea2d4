#include "server/operation/long_work.h"

#include "server/operation/memory_account.h"

namespace tia::server {

void LongWork::run(const Need& need, const Asker& asker, const std::function<void()>& work) {
  const auto ticket = admission_.read(need.bytes, asker.client, asker.stop);
  reserve_memory(need.memory, need.what, asker.stop);
  Flow flow{asker.number()};
  pool_.alone(work, asker.stop, &flow);
  settle_memory();
}

}  // namespace tia::server
