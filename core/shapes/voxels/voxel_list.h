// VoxelList: which cells of a grid are filled, as a scene lists them: cell by cell or in runs. What
// grid it is the list does not know (voxels.h).
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/input/codec.h"

namespace tia {

/// The greatest number that a cell's material has.
inline constexpr int most_cell_material = 255;
/// The most cells that a grid has.
inline constexpr int most_cells = 1 << 24;

/// VoxelList: a list whose elements are all of one form, in JSON
///   n             a run of n cells, by turns empty and filled, an empty one first
///   [n, m]        a run of n cells of material m, 0: empty
///   [i, j, k]     a filled cell
///   [i, j, k, m]  a filled cell of material m
struct VoxelList {
  int width = 0;                      ///< how many numbers an element has: 1 to 4; 0: none yet
  std::vector<std::int32_t> numbers;  ///< of all elements in turn

  std::size_t size() const {
    return width == 0 ? 0 : numbers.size() / static_cast<std::size_t>(width);
  }
  int number(std::size_t element, int k) const {
    return numbers[element * static_cast<std::size_t>(width) + static_cast<std::size_t>(k)];
  }
  bool in_runs() const { return width <= 2; }
  bool has_materials() const { return width % 2 == 0; }
  /// Of an element of a list that has them.
  int material(std::size_t element) const { return number(element, width - 1); }
  bool operator==(const VoxelList&) const = default;
};

/// Errors: the place of what is no element, or of another form than the first is.
template <>
struct Codec<VoxelList> {
  static void read(const Value& v, const Place& at, const Spec& spec, Faults& faults,
                   VoxelList& out);
  static Value write(const VoxelList& v);
  static Value schema(const Spec&);
  static std::string allowed(const Spec&);
};

}  // namespace tia
