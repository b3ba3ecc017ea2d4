// Grids of voxels, as tests make them.
#pragma once

#include "core/shapes/voxels/voxels.h"
#include "tests/core/shapes/lines.h"

namespace tia::test {

using Cell = std::array<int, 3>;

inline Voxels grid_of(const Cell& size, const std::vector<Cell>& cells) {
  Voxels v;
  v.size = size;
  v.occupied.width = 3;
  for (const Cell& cell : cells)
    v.occupied.numbers.insert(v.occupied.numbers.end(), cell.begin(), cell.end());
  return v;
}

inline std::vector<Cell> all_cells(const Cell& size) {
  std::vector<Cell> all;
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i) all.push_back({i, j, k});
  return all;
}

inline std::vector<Crossing> crossings_of(const VoxelsForm& form, const Line& line) {
  std::vector<Crossing> all;
  crossings(form, line, [&](double t, int element) { all.push_back({t, element}); });
  return all;
}
inline std::vector<double> distances(const std::vector<Crossing>& crossings) {
  std::vector<double> all;
  for (const Crossing& each : crossings) all.push_back(each.t);
  return all;
}

}  // namespace tia::test
