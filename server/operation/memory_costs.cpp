#include "server/operation/memory_costs.h"

#include <algorithm>
#include <array>

namespace tia::server {

std::span<const MemoryCost> memory_costs() {
  using namespace memory_cost;
  static constexpr std::array table{text,   value,  patch,   build,          png,  alpha,   linear,
                                    layers, rounds, denoise, denoise_thread, gaze, encoder, webm,
                                    webp,   model,  request};
  return table;
}

std::int64_t memory_for_text(std::size_t bytes, std::size_t most_values) {
  constexpr std::size_t shortest_value = 3;  // "{},"
  const std::size_t values = std::min(bytes / shortest_value, most_values);
  return std::max(memory_for(memory_cost::text, bytes), memory_for(memory_cost::value, values));
}

}  // namespace tia::server
