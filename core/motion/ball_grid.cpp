#include "core/motion/ball_grid.h"

#include <algorithm>
#include <cmath>

#include "core/motion/falls.h"

namespace tia {
namespace {

std::array<double, 3> components(const Vec3d& v) { return {v.x, v.y, v.z}; }

}  // namespace

BallGrid::BallGrid(const Aabb& box, double least_side, std::size_t cells, std::size_t balls)
    : cells_of_(balls) {
  const auto low = components(box.min), size = components(box.size());
  // The widest cubes of which there are no more than `cells`, found by doubling.
  const auto count_along = [&](std::size_t axis, double side) {
    return std::clamp(static_cast<int>(std::min(size[axis] / side, 1e4)), 1, 10'000);
  };
  double side = std::max({size[0], size[1], size[2], least_side});
  const auto count_of = [&](double width) {
    double product = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) product *= count_along(axis, width);
    return product;
  };
  while (side / 1.25 >= least_side && count_of(side / 1.25) <= static_cast<double>(cells))
    side /= 1.25;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    counts_[axis] = count_along(axis, side);
    origin_[axis] = low[axis];
    sides_[axis] = std::max(size[axis] / counts_[axis], side);
  }
  cells_.resize(static_cast<std::size_t>(counts_[0]) * static_cast<std::size_t>(counts_[1]) *
                static_cast<std::size_t>(counts_[2]));
}

void BallGrid::enter(std::size_t ball, const Vec3d& center) {
  const auto at = components(center);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double cell = std::floor((at[axis] - origin_[axis]) / sides_[axis]);
    cells_of_[ball][axis] = static_cast<int>(std::clamp(cell, 0.0, counts_[axis] - 1.0));
  }
  cells_[index(cells_of_[ball])].push_back(static_cast<std::uint32_t>(ball));
}

void BallGrid::leave(std::size_t ball) {
  auto& cell = cells_[index(cells_of_[ball])];
  *std::find(cell.begin(), cell.end(), ball) = cell.back();
  cell.pop_back();
}

void BallGrid::cross(std::size_t ball, int face) {
  leave(ball);
  cells_of_[ball][static_cast<std::size_t>(face / 2)] += face % 2 == 0 ? -1 : 1;
  cells_[index(cells_of_[ball])].push_back(static_cast<std::uint32_t>(ball));
}

BallGrid::Crossing BallGrid::next_crossing(std::size_t ball, const Flight& flight) const {
  const auto x = components(flight.position), v = components(flight.velocity),
             a = components(flight.acceleration);
  Crossing next;
  const auto try_face = [&](double height, double rate, double bend, int face) {
    const Falls falls = falls_of(std::array{height, rate, bend}, Aabb::far, GapStart::apart);
    if (falls.count > 0 && falls.times[0] < next.time) next = {falls.times[0], face};
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int cell = cells_of_[ball][axis], face = 2 * static_cast<int>(axis);
    const double low = origin_[axis] + cell * sides_[axis],
                 high = origin_[axis] + (cell + 1) * sides_[axis];
    if (cell > 0) try_face(x[axis] - low, v[axis], a[axis] / 2, face);
    if (cell + 1 < counts_[axis]) try_face(high - x[axis], -v[axis], -a[axis] / 2, face + 1);
  }
  return next;
}

}  // namespace tia
