#include "core/scene/displays/view_grid.h"

namespace tia {

std::string numbered_view(int number, int count) {
  const std::string digits = std::to_string(number), last = std::to_string(count - 1);
  return "view_" + std::string(last.size() - digits.size(), '0') + digits;
}

}  // namespace tia
