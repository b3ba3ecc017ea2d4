// BallGrid: cells at least as wide as any two balls that touch are apart, so that a ball meets only
// those of its own cell and of the 26 around it. What is beyond the grid is in its outermost cells.
// Source: Alder, Wainwright, "Studies in Molecular Dynamics I", J. Chem. Phys. 31 (1959), appendix.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/math/aabb.h"
#include "core/motion/contact_time.h"

namespace tia {

class BallGrid {
 public:
  using Cell = std::array<int, 3>;

  /// Cells at least `least_side` wide over a box, about `cells` of them, or one.
  BallGrid(const Aabb& box, double least_side, std::size_t cells, std::size_t balls);

  void enter(std::size_t ball, const Vec3d& center);
  void leave(std::size_t ball);
  /// Into the next cell, across face 2 * axis + (1 upwards).
  void cross(std::size_t ball, int face);

  /// Crossing: when a ball leaves its cell, and across which face.
  struct Crossing {
    double time = Aabb::far;
    int face = 0;
  };
  Crossing next_crossing(std::size_t ball, const Flight& flight) const;

  /// Calls visit(other) for the balls that may touch it.
  template <class Visit>
  void for_each_near(std::size_t ball, Visit visit) const {
    const Cell& at = cells_of_[ball];
    for (int z = std::max(at[2] - 1, 0); z <= std::min(at[2] + 1, counts_[2] - 1); ++z)
      for (int y = std::max(at[1] - 1, 0); y <= std::min(at[1] + 1, counts_[1] - 1); ++y)
        for (int x = std::max(at[0] - 1, 0); x <= std::min(at[0] + 1, counts_[0] - 1); ++x)
          for (const std::uint32_t other : cells_[index({x, y, z})])
            if (other != ball) visit(std::size_t{other});
  }

 private:
  std::size_t index(const Cell& cell) const {
    const auto along = [&](std::size_t axis) { return static_cast<std::size_t>(cell[axis]); };
    return (along(2) * static_cast<std::size_t>(counts_[1]) + along(1)) *
               static_cast<std::size_t>(counts_[0]) +
           along(0);
  }

  std::array<double, 3> origin_{};
  std::array<double, 3> sides_{};
  Cell counts_{1, 1, 1};
  std::vector<std::vector<std::uint32_t>> cells_;
  std::vector<Cell> cells_of_;  // by ball
};

}  // namespace tia
