#include "core/scene/limits.h"

namespace tia {

void check_size(int width, int height, const Limits& limits) {
  const std::int64_t pixels = static_cast<std::int64_t>(width) * height;
  if (pixels <= limits.max_pixels) return;
  throw InputError({FaultKind::limit, "/width",
                    Value(std::to_string(width) + " x " + std::to_string(height)),
                    "width x height of at most " + std::to_string(limits.max_pixels) +
                        " pixels (option TIA_MAX_PIXELS)"});
}

}  // namespace tia
