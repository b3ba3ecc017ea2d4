// What a mesh has at a point of one of its triangles, as its corners' numbers say.
#pragma once

#include <array>

#include "core/accel/mesh/mesh_index.h"
#include "core/materials/texture_map.h"

namespace tia {

/// TrianglePoint: a point of a triangle by the shares of its area that face each corner, from
/// which follows all that its mesh has there.
struct TrianglePoint {
  const MeshIndex& mesh;
  std::array<std::uint32_t, 3> corners;  ///< their numbers
  std::array<Vec3d, 3> corner;
  Vec3d whole;  ///< twice the area, along the normal
  std::array<double, 3> share;

  TrianglePoint(const MeshIndex& mesh, std::size_t triangle, const Vec3d& p);
};

/// The interpolated normal, unit; where the mesh has none, the geometric one.
Vec3d normal_of(const TrianglePoint& at);

/// MeshPoint: the geometric normal and the interpolated one, both unit, and the surface
/// coordinates.
struct MeshPoint {
  Vec3d ng, n;
  Vec2d uv;
};
/// If the mesh has no uvs, they are barycentric coordinates.
MeshPoint point_of(const TrianglePoint& at);
inline MeshPoint point_of(const MeshIndex& mesh, std::size_t triangle, const Vec3d& p) {
  return point_of(TrianglePoint(mesh, triangle, p));
}

/// MeshTexturePoint: what textures need to know there. A mesh without a second set of uvs has the
/// first in its place.
struct MeshTexturePoint {
  std::array<Vec2d, 2> uv{};
  std::array<double, 4> color{1, 1, 1, 1};
  std::array<double, 2> uv_area{};  ///< twice what it covers of each set; 0: barycentric ones
};
MeshTexturePoint texture_point_of(const TrianglePoint& at);

/// The mesh's colour there, linear RGB and alpha. Domain: a mesh that has colours.
std::array<double, 4> color_of(const TrianglePoint& at);

/// MeshTangent: unit, at a right angle to n; `sign`: the bitangent is sign n x t.
struct MeshTangent {
  Vec3d t{};
  double sign = 1;
};
/// The mesh's own tangent there, else the direction in which a picture's rows run on the triangle,
/// and its columns upward; some direction where the uvs tell none.
/// Domain: unit n, the interpolated normal there.
MeshTangent tangent_of(const TrianglePoint& at, const TextureMap& map, const Vec3d& n);

}  // namespace tia
