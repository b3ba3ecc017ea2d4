// Voxels: a grid of cells, each empty or filled with one of the object's materials.
#pragma once

#include <array>
#include <memory>
#include <string_view>
#include <variant>
#include <vector>

#include "core/shapes/crossing.h"
#include "core/shapes/voxels/voxel_list.h"

namespace tia {

/// Voxels. Surface: what bounds the union of the filled cells; a face that two of them share is
/// none, whatever their materials. Cell [i, j, k] is the box from origin + cell * [i, j, k] to
/// origin + cell * [i + 1, j + 1, k + 1]; runs go along x first, then y, then z.
/// Space/units: scene units, object space.
struct Voxels {
  static constexpr std::string_view type = "voxels";
  std::array<int, 3> size{1, 1, 1};
  Vec3d origin{};
  std::variant<double, Vec3d> cell = 1.0;
  VoxelList occupied;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("size", &Voxels::size,
          Spec{.about = "how many cells along x, y and z; at most 16777216 in all, 33554432 with "
                        "the scene's other voxels",
               .min = 1,
               .max = 1024,
               .required = true});
    visit("origin", &Voxels::origin,
          Spec{.about = "the grid's corner of least coordinates", .min = -1e9, .max = 1e9});
    visit("cell", &Voxels::cell,
          Spec{.about = "a cell's edges", .min = 0, .max = 1e6, .open_min = true});
    visit("occupied", &Voxels::occupied,
          Spec{.about = "the filled cells: [i, j, k], or [i, j, k, m] of the m-th of the object's "
                        "materials; or runs, x first, then y, then z: lengths, by turns empty and "
                        "filled, or [count, m], m = 0 where empty",
               .required = true});
  }
  /// Too many cells; what lies outside the grid; a cell of two materials; nothing filled. A cell
  /// may be named twice alike.
  void check(const Place& at, Faults& faults) const;
  /// Numbers beyond the materials that the object has.
  void check_materials(std::size_t materials, const Place& at, Faults& faults) const;
  bool operator==(const Voxels&) const = default;
};

/// CellRange: the cells with low <= index < high on each axis.
struct CellRange {
  std::array<int, 3> low{}, high{};
};

/// VoxelGrid: each cell's byte, x first: 0 is empty, else the material's number, 1 where the cells
/// have none.
struct VoxelGrid {
  std::array<int, 3> size{};
  std::vector<std::uint8_t> cells;
};

/// VoxelsForm: copies share the cells. An element is 6 * material + face, material 0 where cells
/// have no numbers; faces 0 to 5: -x, +x, -y, +y, -z, +z.
struct VoxelsForm {
  static constexpr bool solid = true;
  std::shared_ptr<const VoxelGrid> grid;
  CellRange filled;  ///< around all that is filled
  Vec3d origin{}, cell{};
  int materials = 0;  ///< the greatest number
};

/// Domain: voxels that were read without a fault. Cost: O(cells).
VoxelsForm prepare(const Voxels& voxels);
/// A box around what is filled. Cost: O(elements of `occupied`).
Aabb bounds(const Voxels& voxels);
static_assert(TellsBounds<Voxels>);

std::size_t heap_bytes(const VoxelsForm& voxels);
inline int elements(const VoxelsForm& v) { return 6 * (v.materials + 1); }
inline int material_number(const VoxelsForm&, int element) { return element / 6; }
Aabb bounds(const VoxelsForm& voxels);
/// Of finding where a line enters; each cell on its way adds one.
inline int work_of(const VoxelsForm&) { return 8; }

/// CellWalk: a line's way from cell to cell.
///
/// The half-open rule: the line meets the plane of index i at (i - o) / d, in units of the cells,
/// o and d taken along the plane's axis; it is in a cell from the last to the first of that cell's
/// planes, and visits the cell if the first is before the last. So a line through an edge or a
/// corner passes all its planes at once and visits none of the cells that it only touches there;
/// the crossing lies on the face across the first of those axes. A line in a plane runs in the
/// cells behind it, those of the greater index. Source: Amanatides, Woo, "A Fast Voxel Traversal
/// Algorithm for Ray Tracing", Eurographics 1987; but each t from its plane's index: what is summed
/// up drifts.
class CellWalk {
 public:
  /// From t = after on; the form outlives the walk.
  CellWalk(const VoxelsForm& voxels, const Line& line, double after);
  /// The next crossing with t < before, or one at infinity. Domain: a `before` no less than the
  /// last.
  Crossing next(double before = Aabb::far);
  /// How many planes it has passed.
  std::int64_t steps() const { return steps_; }

 private:
  double t_of(std::size_t axis, int plane) const { return (plane - o_[axis]) / d_[axis]; }
  struct Stretch {
    double in = Aabb::far, out = -Aabb::far;
    std::size_t axis = 0;  ///< whose plane it begins at
  };
  Stretch within(const CellRange& range) const;
  void place(std::size_t axis, const CellRange& range, double start);
  void pass(std::size_t axis);
  Crossing crossing(double t, int cell, std::size_t axis, bool in) const;

  const std::uint8_t* cells_;
  bool numbered_;
  bool done_ = true;
  std::array<double, 3> o_{}, d_{};  ///< in units of the cells
  std::array<int, 3> index_{}, step_{}, end_{};
  std::array<std::ptrdiff_t, 3> stride_{};  ///< of a step
  std::array<double, 3> t_{};               ///< of the next plane
  std::ptrdiff_t at_ = 0;
  int inside_ = 0;  ///< the byte of the cell that the line is in; 0 outside
  Crossing entry_;  ///< into a filled cell at the edge of all; none once it is told
  std::int64_t steps_ = 0;
};

template <class Emit>
std::int64_t crossings(const VoxelsForm& voxels, const Line& line, Emit&& emit) {
  CellWalk walk(voxels, line, -Aabb::far);
  for (Crossing each = walk.next(); each.t < Aabb::far; each = walk.next())
    emit(each.t, each.element);
  return walk.steps();
}
FirstCrossing first_crossing(const VoxelsForm& voxels, const Line& line, double after,
                             double before);

Vec3d normal(const VoxelsForm& voxels, const Vec3d& p, int element);
/// Returns: the place within the cell's face along its two axes: y z, z x or x y.
Vec2d uv(const VoxelsForm& voxels, const Vec3d& p, int element);

static_assert(IsForm<VoxelsForm>);
static_assert(TellsWork<VoxelsForm>);
static_assert(NumbersMaterials<VoxelsForm>);
static_assert(FindsFirstCrossing<VoxelsForm>);

}  // namespace tia
