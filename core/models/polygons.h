// Polygons cut into triangles, for readers of files that have them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace tia {

/// Appends three indices a triangle: n - 2 triangles of a polygon of n corners, none where there
/// are fewer than three. Three corners stay as they are. Of more, the first ear is cut, from the
/// first corner left, again and again: a corner of positive area whose triangle has no other corner
/// that is not so inside or on it (but in its corners' places). Seen along Newell's normal, each
/// triangle turns as the polygon does. Where there is no ear, as in what crosses itself or lies in
/// a line, the first corner is cut. A corner is looked at anew when one beside it is cut.
/// Shape: `positions` x, y, z; `corners` are indices of these, and may be equal.
/// Domain: indices of what is there; finite positions, below 1e100 or so.
/// Cost: linear where all corners are convex, else at most quadratic in the corners.
/// Source: Meisters, "Polygons have ears", Amer. Math. Monthly 82 (1975); Sutherland, Sproull and
/// Schumacker, "A characterization of ten hidden-surface algorithms" (1974) for Newell's normal.
void triangulate(std::span<const std::uint32_t> corners, std::span<const double> positions,
                 std::vector<std::uint32_t>& triangles);

}  // namespace tia
