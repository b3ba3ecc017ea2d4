// Strata: a division of the unit square into parts of equal area.
#pragma once

#include <cstdint>
#include <vector>

namespace tia {

/// Strata: the unit square cut into n cells of equal area, whatever n: round(sqrt n) rows, each
/// as high as it has cells, their numbers differing by at most one.
class Strata {
 public:
  struct Cell {
    float x, y, width, height;
  };
  /// Domain: 1 <= n < 2^24.
  explicit Strata(int n);
  int count() const { return static_cast<int>(cells_.size()); }
  const Cell& operator[](std::uint32_t i) const { return cells_[i]; }

 private:
  std::vector<Cell> cells_;
};

}  // namespace tia
