// Tangents for what has none: MikkTSpace.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace tia {

/// TangentSource: triangles to find tangents of. Shape: x, y, z of each position and normal; u and
/// v of each vertex, v upward; three indices a triangle. Without normals all is flat.
struct TangentSource {
  std::span<const double> positions, normals, uvs;
  std::span<const std::uint32_t> indices;
};

/// TangentVertices: vertices parted where faces do not share a tangent, as at seams of mirrored
/// uvs: the given ones first, each with the tangent of its first face, then those that had to be
/// added.
struct TangentVertices {
  std::vector<std::uint32_t> from;     ///< of each that is added, the given vertex that it is
  std::vector<std::uint32_t> indices;  ///< three a triangle, in the given order
  std::vector<double> tangents;  ///< x, y, z of each vertex, unit, and w: the bitangent's sign
};

/// Where corners have the same place, normal and uv, the faces around that are linked by edges and
/// run their uvs the same way round share a tangent: the sum of the directions in which u grows on
/// each, in the normal's plane, weighted by the angle there. Faces on which uvs tell no direction
/// take their neighbours'. As the reference does at its default angle of 180 degrees, but for faces
/// whose tangents are opposite to the last bit, which it keeps apart.
/// Domain: indices of what is there; finite numbers. Cost: O(n log n).
/// Source: Mikkelsen, "Simulation of wrinkled surfaces revisited", 2008, 3; mikktspace.c.
TangentVertices tangents_of(const TangentSource& mesh);

}  // namespace tia
