// MeshIndex: a mesh with a tree over its triangles, and these packed in float in the order of the
// tree's leaves.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/accel/mesh/points.h"
#include "core/accel/mesh/triangle.h"
#include "core/boxes/bvh_builder.h"
#include "core/boxes/packed_leaves.h"
#include "core/math/tolerances.h"
#include "core/shapes/crossing.h"
#include "core/shapes/mesh/mesh.h"

namespace tia {

struct MeshIndex {
  Points positions;
  HugeVector<Vec3d> normals;                  ///< one a position, unit; empty: flat
  HugeVector<Vec2d> uvs;                      ///< one a position; empty: none
  HugeVector<Vec2d> more_uvs;                 ///< likewise, a second set
  HugeVector<std::array<float, 4>> colors;    ///< likewise, linear RGB and alpha
  HugeVector<std::array<float, 4>> tangents;  ///< likewise, x, y, z and the bitangent's sign
  /// All of the mesh's, degenerate ones as well. If there are normals, wound to the side of these.
  HugeVector<std::array<std::uint32_t, 3>> triangles;
  Bvh bvh;  ///< over the triangles that are not degenerate
  std::size_t degenerate = 0;

  /// Triangles are packed in coordinates from -1 to 1 around the middle, in multiples of `unit`, so
  /// that float is equally precise for a mesh of any size at any place.
  Vec3d middle{};
  double unit = 1;  ///< a power of two
  /// Of each triangle the nine coordinates of its corners, all x, all y, all z, and the bits of its
  /// number, so that a ray alone need not look it up in bvh.order.
  PackedLeaves<float, 10> packed;
  /// Plane: dot(n, p) = d, in units of the mesh; of a triangle, in whose plane hits are settled.
  struct alignas(32) Plane {
    Vec3d n;
    double d;
  };
  HugeVector<Plane> planes;  ///< one a triangle; of one without area 0

  /// Errors: Stopped.
  explicit MeshIndex(const Mesh& mesh, const Workers& workers = {});
  Vec3d corner(std::size_t triangle, std::size_t i) const {
    return positions[triangles[triangle][i]];
  }
  /// The distance along a line to the plane of that triangle, in units of the mesh; of any sign.
  double plane_distance(std::size_t triangle, const Line& line) const;
  /// A point in these coordinates.
  Vec3d measured(const Vec3d& p) const { return (p - middle) * (1 / unit); }
  /// Packs the triangles as the leaves of `bvh` list them, and finds their planes.
  void pack(const Workers& workers = {});

 private:
  void wind_to_normals();
  std::vector<std::uint32_t> sound_triangles(const Workers& workers);
  bool is_sound(std::size_t triangle) const;
  void measure(const std::vector<std::uint32_t>& sound);
  Box32 measured_box(std::size_t triangle) const;
};

/// MeshRay: rays in the coordinates in which triangles are packed. A ray that starts far from the
/// mesh is moved along itself to next to the mesh: t = start + m * rate for a distance m in units
/// of it.
///
/// Where a mesh is large beside the distances of a ray, the offset from its surface (offset_of) is
/// less than what float errs by (tolerance::mesh_large). Near hits are then settled in double, or
/// the surface would shadow itself.
template <class Real>
struct MeshRay {
  using P = Precise<Real>;
  Vec3<P> exact_origin, exact_direction;
  Vec3<Real> origin, direction;
  P start, rate, inverse_rate;
  Real near;  ///< hits with m below this are settled in double; 0: none are

  /// Domain: rays in the mesh's object space. `unit_length`: whether their directions are unit;
  /// `extent`: the largest coordinate of their origins in world space.
  MeshRay(const MeshIndex& mesh, const RootRay<Real>& ray, bool unit_length, const Real& extent);
  /// One of them.
  Line exact(int i) const {
    const auto of = [i](const Vec3<P>& v) -> Vec3d {
      return {lane(v.x, i), lane(v.y, i), lane(v.z, i)};
    };
    return {of(exact_origin), of(exact_direction)};
  }
  Real t_of(const Real& m) const { return narrow<Real>(start + widen(m) * rate); }
  Real m_of(const Real& t) const { return narrow<Real>((widen(t) - start) * inverse_rate); }
};

template <class Real>
MeshRay<Real>::MeshRay(const MeshIndex& mesh, const RootRay<Real>& ray, bool unit_length,
                       const Real& extent) {
  using std::sqrt;
  const double per_unit = 1 / mesh.unit;
  const Vec3<P> from = ray.origin - static_cast<Vec3<P>>(mesh.middle);
  exact_direction = ray.direction;
  rate = P(mesh.unit), inverse_rate = P(per_unit);
  if (!unit_length) {
    const P length = sqrt(dot(ray.direction, ray.direction));
    exact_direction = exact_direction * (P(1) / length);
    rate = rate / length, inverse_rate = inverse_rate * length;
  }
  // All of the mesh is less than 2 units from its middle, so 3 units before it nothing is missed.
  const P before = -dot(from, ray.direction) * ray.inverse_a - P(3) * rate;
  start = (before + abs_of(before)) * P(0.5);
  exact_origin = (from + ray.direction * start) * P(per_unit);
  const auto rounded = [](const Vec3<P>& v) -> Vec3<Real> {
    return {narrow<Real>(v.x), narrow<Real>(v.y), narrow<Real>(v.z)};
  };
  origin = rounded(exact_origin);
  direction = rounded(exact_direction);
  const Real distance = max_of(extent, narrow<Real>(start));
  const Mask<Real> is_large = !(distance >= narrow<Real>(rate) * Real(tolerance::mesh_large));
  near = select(is_large, Real(tolerance::mesh_near), Real(0));
}

}  // namespace tia
