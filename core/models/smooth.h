// Normals for what has none: faces that meet at small angles share them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace tia {

/// SmoothVertices: vertices parted where faces do not share a normal. Shape: three indices a
/// triangle, in the given order; x, y, z of each normal, unit.
struct SmoothVertices {
  std::vector<std::uint32_t> from;  ///< of each, the given vertex that it is
  std::vector<std::uint32_t> indices;
  std::vector<double> normals;  ///< none where all is flat: then nothing is parted either
};

/// Faces share a normal at both ends of an edge where they meet at less than the angle, and so do
/// all that are linked thus around a corner; corners in one place count as one. A shared normal is
/// the sum over the faces of the cross product of both edges there, over the squares of their
/// lengths, which on balls is exact however they are cut. Edges of more than eight faces, and faces
/// without area, share none.
/// Shape: `positions` x, y, z; three indices a triangle. Domain: indices of what is there; finite
/// positions; degrees from 0 to 180. Cost: O(n log n).
/// Source: Max, "Weights for computing vertex normals from facet normals", Journal of Graphics
/// Tools 4(2) (1999).
SmoothVertices smooth(std::span<const double> positions, std::span<const std::uint32_t> indices,
                      double degrees);

/// What the list has of each of those vertices. Shape: `width` numbers a vertex; or none.
template <class Number>
std::vector<Number> taken(const std::vector<Number>& list, const std::vector<std::uint32_t>& from,
                          std::size_t width) {
  std::vector<Number> all;
  if (list.empty()) return all;
  all.reserve(from.size() * width);
  for (const std::uint32_t i : from) {
    const auto first = list.begin() + static_cast<std::ptrdiff_t>(i * width);
    all.insert(all.end(), first, first + static_cast<std::ptrdiff_t>(width));
  }
  return all;
}

}  // namespace tia
