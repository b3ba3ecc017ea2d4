#include "server/operation/memory_costs.h"

#include <array>

namespace tia::server {

std::span<const MemoryCost> memory_costs() {
  using namespace memory_cost;
  static constexpr std::array table{text, patch, build, png, linear, request};
  return table;
}

}  // namespace tia::server
