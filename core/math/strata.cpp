#include "core/math/strata.h"

#include <cmath>

namespace tia {

Strata::Strata(int n) {
  cells_.reserve(static_cast<std::size_t>(n));
  const auto rows = static_cast<int>(std::lround(std::sqrt(static_cast<double>(n))));
  const auto first_of = [&](int row) { return static_cast<int>(std::int64_t{row} * n / rows); };
  for (int row = 0; row < rows; ++row) {
    const int first = first_of(row), count = first_of(row + 1) - first;
    const float y = static_cast<float>(first) / static_cast<float>(n);
    const float height = static_cast<float>(count) / static_cast<float>(n);
    const float width = 1 / static_cast<float>(count);
    for (int i = 0; i < count; ++i)
      cells_.push_back({static_cast<float>(i) / static_cast<float>(count), y, width, height});
  }
}

}  // namespace tia
