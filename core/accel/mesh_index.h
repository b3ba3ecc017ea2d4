// MeshIndex: a mesh as the tracer needs it: triangles in an index, tried on whole packets.
#pragma once

#include <array>
#include <cstdint>
#include <stop_token>
#include <vector>

#include "core/accel/bvh.h"
#include "core/math/onb.h"
#include "core/shapes/crossing.h"
#include "core/shapes/mesh.h"

namespace tia {

struct MeshIndex {
  std::vector<Vec3d> positions;
  std::vector<Vec3d> normals;                           ///< one a position, unit; empty: flat
  std::vector<Vec2d> uvs;                               ///< one a position; empty: none
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< all of the mesh's, the degenerate too
  Bvh bvh;                                              ///< over those that are not degenerate
  std::size_t degenerate = 0;

  /// Errors: Stopped.
  explicit MeshIndex(const Mesh& mesh, const std::stop_token& stop = {});
  const Vec3d& corner(std::size_t triangle, std::size_t i) const {
    return positions[triangles[triangle][i]];
  }
};

/// The geometric normal and the smooth one, both unit, and the surface coordinates.
struct MeshPoint {
  Vec3d ng, n;
  Vec2d uv;
};
/// At a point of that triangle; the uvs are barycentric where the mesh has none.
MeshPoint point_of(const MeshIndex& mesh, std::size_t triangle, const Vec3d& p);

/// RayFrame: rays, and two axes across each, along which a mesh's corners are measured.
template <class P>
struct RayFrame {
  Vec3<P> origin, along, across, upwards;
  P per_length;  ///< 1 / |along|^2
};

/// Found lane by lane, once for all triangles.
template <class Real>
RayFrame<Precise<Real>> frame_of(const Packet<Real>& packet) {
  using P = Precise<Real>;
  constexpr auto n = static_cast<std::size_t>(lanes<Real>);
  std::array<std::array<double, n>, 6> axes;
  const Lines<Real> lines(packet.root);
  for (std::size_t lane = 0; lane < n; ++lane) {
    const Onb basis = onb_around(normalize(lines[lane].direction));
    const double all[] = {basis.u.x, basis.u.y, basis.u.z, basis.v.x, basis.v.y, basis.v.z};
    for (std::size_t i = 0; i < 6; ++i) axes[i][lane] = all[i];
  }
  const auto vector = [&](std::size_t i) -> Vec3<P> {
    return {load<P>(axes[i].data()), load<P>(axes[i + 1].data()), load<P>(axes[i + 2].data())};
  };
  return {packet.root.origin, packet.root.direction, vector(0), vector(3), packet.root.inverse_a};
}

/// Where the rays meet a triangle: t from their frame, infinite where they miss.
///
/// Watertight: a corner's place across the ray comes out the same for every triangle that has it,
/// so the edge that two triangles share is on the same side of the ray for both; on an edge both
/// are hit. Source: Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection", JCGT 2 (2013),
/// with two axes across the ray in place of a shear, so that lanes need no permutation.
template <class Real>
Real intersect(const Vec3d& a, const Vec3d& b, const Vec3d& c, const RayFrame<Precise<Real>>& ray) {
  using P = Precise<Real>;
  const Vec3<P> to_a = static_cast<Vec3<P>>(a) - ray.origin;
  const Vec3<P> to_b = static_cast<Vec3<P>>(b) - ray.origin;
  const Vec3<P> to_c = static_cast<Vec3<P>>(c) - ray.origin;
  const P ax = dot(to_a, ray.across), ay = dot(to_a, ray.upwards);
  const P bx = dot(to_b, ray.across), by = dot(to_b, ray.upwards);
  const P cx = dot(to_c, ray.across), cy = dot(to_c, ray.upwards);
  const P u = cx * by - cy * bx, v = ax * cy - ay * cx, w = bx * ay - by * ax;
  const Real u1 = narrow<Real>(u), v1 = narrow<Real>(v), w1 = narrow<Real>(w), zero(0);
  const auto inside =
      (u1 >= zero && v1 >= zero && w1 >= zero) || (u1 <= zero && v1 <= zero && w1 <= zero);
  if (!any(inside)) return Real(infinity);
  const P area = u + v + w;
  const P depth = u * dot(to_a, ray.along) + v * dot(to_b, ray.along) + w * dot(to_c, ray.along);
  // 0/0 where the ray runs in the triangle's plane: a triangle has no thickness to hit.
  const Real t = narrow<Real>(depth / area * ray.per_length);
  return select(inside && t > zero && t < Real(infinity), t, Real(infinity));
}

}  // namespace tia
