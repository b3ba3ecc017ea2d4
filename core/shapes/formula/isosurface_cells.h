// Where a function f(x, y, z) may be 0: a tree of boxes, made once by interval arithmetic, and in
// each box a linear approximation of f with a proven bound of its error.
#pragma once

#include <memory>

#include "core/boxes/line_traversal.h"
#include "core/formulas/program.h"
#include "core/shapes/bounds.h"

namespace tia {

/// IsosurfaceCell: what is proven of f in one box. Where it is `smooth`, that is, defined
/// and continuous, |f(p) - offset - gradient . (p - middle)| <= slack, and the slope of f along any
/// d differs from gradient . d by at most spread . |d| (mean value theorem).
struct IsosurfaceCell {
  Vec3d gradient{};
  double offset = 0, slack = 0;
  Vec3f spread{};
  bool smooth = false;
};

/// IsosurfaceCells: the cells of f within a region. Outside of them f has no root: each connected
/// part of the rest is wholly below 0, above 0 or undefined.
struct IsosurfaceCells {
  OffsetBvh tree;  ///< whose leaves are the cells
  std::vector<IsosurfaceCell> cells;
  std::size_t flat = 0;  ///< how many of them are nearly so: see cells_of

  double flat_share() const {
    return cells.empty() ? 1 : static_cast<double>(flat) / static_cast<double>(cells.size());
  }
};

/// Divides cells until f is nearly linear in each, or there are too many.
/// Cost: bounded by about a tenth of a second, whatever the function.
/// Source: Knoll et al., "Interactive Ray Tracing of Arbitrary Implicits with SIMD Interval
/// Arithmetic", IEEE RT 2007, for discarding boxes by intervals; here that is done once in
/// space, there for each ray.
IsosurfaceCells cells_of(const Program& function, const Region& region);

}  // namespace tia
