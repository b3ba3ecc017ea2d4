// Triangles that fill a polygon with holes.
#pragma once

#include <cstdint>
#include <vector>

namespace tia {

/// PlanPoint: a place on a map.
struct PlanPoint {
  double x = 0, y = 0;
  bool operator==(const PlanPoint&) const = default;
};
using Ring = std::vector<PlanPoint>;

/// Twice the area inside a ring, > 0 where it goes from x towards y.
double doubled_area(const Ring& ring);

/// Corners of triangles, as numbers of the rings' points one ring after the other. The first ring
/// is around the others. Their turn is the outer ring's; holes turn the other way. Of rings that
/// cross each other the triangles are some that fit. Domain: rings of at least three points, the
/// first not repeated at the end. Cost: the square of the points.
/// Source: Eberly, "Triangulation by ear clipping" (2002): holes are joined to the outer ring by a
/// bridge, then ears are cut off.
std::vector<std::uint32_t> triangles_of(const std::vector<Ring>& rings);

}  // namespace tia
