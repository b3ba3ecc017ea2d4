#include "core/shapes/voxels/voxels.h"

#include <algorithm>
#include <span>

namespace tia {
namespace {

using Cell = std::array<int, 3>;

std::int64_t cells_of(const Voxels& v) { return std::int64_t{v.size[0]} * v.size[1] * v.size[2]; }
std::int64_t number_of(const Voxels& v, const Cell& cell) {
  return cell[0] + v.size[0] * (cell[1] + std::int64_t{v.size[1]} * cell[2]);
}
Cell cell_at(const Voxels& v, std::size_t element) {
  const VoxelList& list = v.occupied;
  return {list.number(element, 0), list.number(element, 1), list.number(element, 2)};
}

/// Calls f(element, first, count, byte) for each run that is filled. Domain: a list of runs.
template <class F>
void for_each_run(const VoxelList& list, F f) {
  std::int64_t first = 0;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const int count = list.number(i, 0);
    const int byte = list.has_materials() ? list.material(i) : static_cast<int>(i % 2);
    if (count > 0 && byte > 0) f(first, count, static_cast<std::uint8_t>(byte));
    first += count;
  }
}

void widen(CellRange& range, std::size_t axis, std::int64_t first, std::int64_t last) {
  range.low[axis] = std::min(range.low[axis], static_cast<int>(first));
  range.high[axis] = std::max(range.high[axis], static_cast<int>(last) + 1);
}

// A run that goes beyond a row holds the end of one and the beginning of another.
void widen_by_run(CellRange& range, const Voxels& v, std::int64_t first, std::int64_t last) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int size = v.size[axis];
    const bool one_row = first / size == last / size;
    widen(range, axis, one_row ? first % size : 0, one_row ? last % size : size - 1);
    first /= size;
    last /= size;
  }
}

CellRange filled_range(const Voxels& v) {
  CellRange range{v.size, {0, 0, 0}};
  if (v.occupied.in_runs()) {
    for_each_run(v.occupied, [&](std::int64_t first, int count, std::uint8_t) {
      widen_by_run(range, v, first, first + count - 1);
    });
    return range;
  }
  for (std::size_t i = 0; i < v.occupied.size(); ++i) {
    const Cell cell = cell_at(v, i);
    for (std::size_t axis = 0; axis < 3; ++axis) widen(range, axis, cell[axis], cell[axis]);
  }
  return range;
}

std::vector<std::uint8_t> bytes_of(const Voxels& v) {
  std::vector<std::uint8_t> cells(static_cast<std::size_t>(cells_of(v)));
  const VoxelList& list = v.occupied;
  if (list.in_runs()) {
    for_each_run(list, [&](std::int64_t first, int count, std::uint8_t byte) {
      std::fill_n(cells.begin() + first, count, byte);
    });
    return cells;
  }
  for (std::size_t i = 0; i < list.size(); ++i) {
    const int byte = list.has_materials() ? list.material(i) : 1;
    cells[static_cast<std::size_t>(number_of(v, cell_at(v, i)))] = static_cast<std::uint8_t>(byte);
  }
  return cells;
}

Vec3d edges(const Voxels& v) {
  if (const auto* edge = std::get_if<double>(&v.cell)) return {*edge, *edge, *edge};
  return std::get<Vec3d>(v.cell);
}

Aabb box_of(const CellRange& range, const Vec3d& origin, const Vec3d& cell) {
  const auto corner = [&](const Cell& at) -> Vec3d {
    return origin + cell * Vec3d{double(at[0]), double(at[1]), double(at[2])};
  };
  return {corner(range.low), corner(range.high)};
}

// ---- checks ---------------------------------------------------------------------------------

std::string integers(int from, int to) {
  return "an integer from " + std::to_string(from) + " to " + std::to_string(to);
}

// Runs that end within the grid.
void check_runs(const Voxels& v, const Place& at, Faults& faults) {
  const VoxelList& list = v.occupied;
  std::int64_t left = cells_of(v);
  for (std::size_t i = 0; i < list.size(); ++i) {
    const int count = list.number(i, 0);
    if (count > left) {
      const Place run = at.at(i);
      const Place place = list.width == 1 ? run : run.at(std::size_t{0});
      faults.add({FaultKind::out_of_range, place.pointer(), count,
                  "at most " + std::to_string(left) + ": so many cells of the grid are left"});
      return;
    }
    left -= count;
  }
}

bool check_index(const Voxels& v, std::size_t element, const Place& at, Faults& faults) {
  const Cell cell = cell_at(v, element);
  bool inside = true;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (cell[axis] < v.size[axis]) continue;
    inside = false;
    faults.add({FaultKind::out_of_range, at.at(axis).pointer(), cell[axis],
                integers(0, v.size[axis] - 1) + ", below the size"});
  }
  return inside;
}

// Cells within the grid, none of two materials.
void check_cells(const Voxels& v, const Place& at, Faults& faults) {
  const VoxelList& list = v.occupied;
  std::vector<std::uint8_t> seen;
  if (list.has_materials()) seen.resize(static_cast<std::size_t>(cells_of(v)));
  for (std::size_t i = 0; i < list.size() && !faults.full(); ++i) {
    if (!check_index(v, i, at.at(i), faults) || !list.has_materials()) continue;
    auto& before = seen[static_cast<std::size_t>(number_of(v, cell_at(v, i)))];
    if (before != 0 && before != list.material(i)) {
      const Place cell = at.at(i);
      faults.add({FaultKind::conflict, cell.at(std::size_t{3}).pointer(), list.material(i),
                  std::to_string(before) + ", the material that the cell was named with before"});
    }
    before = static_cast<std::uint8_t>(list.material(i));
  }
}

bool check_size(const Voxels& v, const Place& at, Faults& faults) {
  const std::int64_t cells = cells_of(v);
  const std::string got = std::to_string(cells) + " cells";
  if (cells > most_cells)
    faults.add({FaultKind::limit, at.pointer(), Value(got),
                "a grid of at most " + std::to_string(most_cells) + " cells"});
  else if (!faults.take(Bulk::cells, cells))
    faults.add({FaultKind::limit, at.pointer(), Value(got + " more"),
                "voxels of at most " + std::to_string(most_of(Bulk::cells)) + " cells together"});
  else return true;
  return false;
}

}  // namespace

void Voxels::check(const Place& at, Faults& faults) const {
  if (!check_size(*this, at.at("size"), faults)) return;
  const std::size_t before = faults.count();
  const Place list = at.at("occupied");
  if (occupied.in_runs()) check_runs(*this, list, faults);
  else check_cells(*this, list, faults);
  if (faults.count() == before && filled_range(*this).high[0] == 0)
    faults.add({FaultKind::out_of_range, list.pointer(), write_value(occupied),
                "at least one filled cell"});
}

void Voxels::check_materials(std::size_t materials, const Place& at, Faults& faults) const {
  if (!occupied.has_materials()) return;
  const int least = occupied.in_runs() ? 0 : 1, most = static_cast<int>(materials);
  const Place list = at.at("occupied");
  for (std::size_t i = 0; i < occupied.size() && !faults.full(); ++i) {
    if (occupied.material(i) <= most) continue;
    const Place element = list.at(i);
    faults.add({FaultKind::out_of_range,
                element.at(static_cast<std::size_t>(occupied.width - 1)).pointer(),
                occupied.material(i),
                most == 0 ? "no number where the object has no materials"
                          : integers(least, most) + ", the number of one of the materials"});
  }
}

VoxelsForm prepare(const Voxels& v) {
  VoxelsForm form;
  form.grid = std::make_shared<const VoxelGrid>(VoxelGrid{v.size, bytes_of(v)});
  form.filled = filled_range(v);
  form.origin = v.origin;
  form.cell = edges(v);
  const VoxelList& list = v.occupied;
  for (std::size_t i = 0; list.has_materials() && i < list.size(); ++i)
    form.materials = std::max(form.materials, list.material(i));
  return form;
}

Aabb bounds(const Voxels& v) { return box_of(filled_range(v), v.origin, edges(v)); }
Aabb bounds(const VoxelsForm& v) { return box_of(v.filled, v.origin, v.cell); }

std::size_t heap_bytes(const VoxelsForm& form) {
  return form.grid ? 2 * heap_block + sizeof(VoxelGrid) + heap_bytes(form.grid->cells) : 0;
}

}  // namespace tia
