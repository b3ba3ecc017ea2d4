// CellWalk, and what a form of voxels finds by it.
#include <cmath>
#include <utility>

#include "core/shapes/voxels/voxels.h"

namespace tia {
namespace {

std::array<double, 3> parts(const Vec3d& v) { return {v.x, v.y, v.z}; }

}  // namespace

CellWalk::CellWalk(const VoxelsForm& voxels, const Line& line, double after)
    : cells_(voxels.grid->cells.data()), numbered_(voxels.materials > 0) {
  const auto o = parts(line.origin - voxels.origin), d = parts(line.direction);
  const auto cell = parts(voxels.cell);
  const auto& size = voxels.grid->size;
  const std::array<std::ptrdiff_t, 3> strides{1, size[0], std::ptrdiff_t{size[0]} * size[1]};
  const CellRange& range = voxels.filled;
  for (std::size_t i = 0; i < 3; ++i) {
    o_[i] = o[i] / cell[i];
    d_[i] = d[i] / cell[i];
    step_[i] = d_[i] > 0 ? 1 : d_[i] < 0 ? -1 : 0;
    stride_[i] = strides[i] * step_[i];
    end_[i] = step_[i] > 0 ? range.high[i] : range.low[i] - 1;
  }
  const Stretch whole = within(range);
  const double start = std::max(whole.in, after);
  if (!(start < whole.out)) return;
  for (std::size_t i = 0; i < 3; ++i) {
    place(i, range, start);
    at_ += strides[i] * index_[i];
  }
  done_ = false;
  inside_ = cells_[at_];
  if (after < whole.in && inside_ != 0) entry_ = crossing(whole.in, inside_, whole.axis, true);
}

// The line's stretch between the outermost planes, an empty one where that is none or all of it.
CellWalk::Stretch CellWalk::within(const CellRange& range) const {
  Stretch held{-Aabb::far, Aabb::far, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    const int low = range.low[i], high = range.high[i];
    if (step_[i] == 0) {
      if (!(d_[i] == 0 && low <= o_[i] && o_[i] < high)) return {};
      continue;
    }
    const double near = t_of(i, step_[i] > 0 ? low : high),
                 far = t_of(i, step_[i] > 0 ? high : low);
    if (!(near <= far)) return {};  // NaN
    if (near > held.in) held.in = near, held.axis = i;
    held.out = std::min(held.out, far);
  }
  return held.out < Aabb::far ? held : Stretch{};
}

// Which cell it is in at `start`, along one axis. Domain: within the range at `start`.
void CellWalk::place(std::size_t i, const CellRange& range, double start) {
  const double there = std::floor(o_[i] + d_[i] * (step_[i] == 0 ? 0 : start));
  const int last = range.high[i] - 1;
  int& index = index_[i];
  index = there >= last ? last : there > range.low[i] ? static_cast<int>(there) : range.low[i];
  t_[i] = Aabb::far;
  if (step_[i] == 0) return;
  // As the planes have it, not as it was rounded.
  const int forward = step_[i] > 0 ? 1 : 0;
  while (t_of(i, index + forward) <= start) index += step_[i];
  while (t_of(i, index + 1 - forward) > start) index -= step_[i];
  t_[i] = t_of(i, index + forward);
}

Crossing CellWalk::next(double before) {
  if (entry_.t < Aabb::far)
    return entry_.t < before ? std::exchange(entry_, Crossing{}) : Crossing{};
  while (!done_) {
    const double t = std::min({t_[0], t_[1], t_[2]});
    if (!(t < before)) return {};
    const std::size_t axis = t == t_[0] ? 0 : t == t_[1] ? 1 : 2;
    for (std::size_t i = axis; i < 3; ++i)
      while (!done_ && t_[i] <= t) pass(i);
    const int left = std::exchange(inside_, done_ ? 0 : cells_[at_]);
    if ((left == 0) == (inside_ == 0)) continue;
    return left == 0 ? crossing(t, inside_, axis, true) : crossing(t, left, axis, false);
  }
  return {};
}

// Goes on behind the next plane of an axis.
void CellWalk::pass(std::size_t i) {
  ++steps_;
  index_[i] += step_[i];
  at_ += stride_[i];
  if (index_[i] == end_[i]) done_ = true;
  else t_[i] = t_of(i, index_[i] + (step_[i] > 0 ? 1 : 0));
}

Crossing CellWalk::crossing(double t, int cell, std::size_t axis, bool in) const {
  const bool at_low = (step_[axis] > 0) == in;
  const int face = 2 * static_cast<int>(axis) + (at_low ? 0 : 1);
  return {t, 6 * (numbered_ ? cell : 0) + face};
}

FirstCrossing first_crossing(const VoxelsForm& voxels, const Line& line, double after,
                             double before) {
  CellWalk walk(voxels, line, after);
  const Crossing first = walk.next(before);
  return {first, walk.steps()};
}

Vec3d normal(const VoxelsForm&, const Vec3d&, int element) {
  const int face = element % 6;
  const double way = face % 2 == 0 ? -1 : 1;
  return {face / 2 == 0 ? way : 0, face / 2 == 1 ? way : 0, face / 2 == 2 ? way : 0};
}

Vec2d uv(const VoxelsForm& voxels, const Vec3d& p, int element) {
  const Vec3d q = p - voxels.origin;
  const auto share = [](double part, double whole) {
    const double cells = part / whole;
    return cells - std::floor(cells);
  };
  const double x = share(q.x, voxels.cell.x), y = share(q.y, voxels.cell.y),
               z = share(q.z, voxels.cell.z);
  const int axis = element % 6 / 2;
  return axis == 0 ? Vec2d{y, z} : axis == 1 ? Vec2d{z, x} : Vec2d{x, y};
}

}  // namespace tia
