// Where a field f(x, y, z) may be 0: boxes in a tree, made once by interval arithmetic, and in each
// the field as a plane's equation that errs by no more than it says.
#pragma once

#include <memory>

#include "core/boxes/line_traversal.h"
#include "core/formulas/program.h"
#include "core/shapes/bounds.h"

namespace tia {

/// FieldCell: what is proven of the field in one box. Where it is `smooth`, that is, defined and
/// continuous, |f(p) - offset - gradient . (p - middle)| <= slack, and the slope of f along any d
/// differs from gradient . d by at most spread . |d| (mean value theorem).
struct FieldCell {
  Vec3d gradient{};
  double offset = 0, slack = 0;
  Vec3f spread{};
  bool smooth = false;
};

/// FieldCells: the cells of a field within a region. Beyond them it is below 0, above 0 or
/// undefined, but never 0, and changes from one to another nowhere.
struct FieldCells {
  OffsetBvh tree;  ///< whose leaves are the cells
  std::vector<FieldCell> cells;
  std::size_t flat = 0;  ///< how many of them are nearly so

  double flat_share() const {
    return cells.empty() ? 1 : static_cast<double>(flat) / static_cast<double>(cells.size());
  }
};

/// Cells shrink until the field is nearly flat in each, or there are too many.
/// Cost: bounded: at most some tenth of a second, whatever the field.
/// Source: Knoll et al., "Interactive Ray Tracing of Arbitrary Implicits with SIMD Interval
/// Arithmetic", IEEE RT 2007, for discarding boxes by intervals; here once in space, not ray by
/// ray.
FieldCells cells_of(const Program& field, const Region& region);

}  // namespace tia
