// The distances of hits on meshes in double, found once for the closest hit of each lane.
#pragma once

#include <array>
#include <bit>
#include <cmath>

#include "core/accel/world/packet.h"
#include "core/accel/world/winners.h"

namespace tia {
namespace detail {

/// LaneVectors: a vector in double for each lane, set one by one.
template <class Real>
class LaneVectors {
 public:
  void set(int lane, const Vec3d& v) {
    const auto i = static_cast<std::size_t>(lane);
    x_[i] = v.x, y_[i] = v.y, z_[i] = v.z;
  }
  Vec3<Precise<Real>> all() const {
    return {tia::load<Precise<Real>>(x_.data()), tia::load<Precise<Real>>(y_.data()),
            tia::load<Precise<Real>>(z_.data())};
  }

 private:
  std::array<double, static_cast<std::size_t>(lanes<Real>)> x_, y_, z_;
};

/// The corners of the triangles that lanes have hit, and of any triangle in the others. First all
/// lanes' indices are read, then all positions, so that memory is waited for by all of them at
/// once.
template <class Real>
std::array<Vec3<Precise<Real>>, 3> corners_of(const MeshIndex& mesh, const Real& triangle,
                                              Mask<Real> here) {
  const Real known = select(here, triangle, Real(0));
  std::array<std::array<std::uint32_t, 3>, static_cast<std::size_t>(lanes<Real>)> corners;
  for (int i = 0; i < lanes<Real>; ++i)
    corners[static_cast<std::size_t>(i)] = mesh.triangles[static_cast<std::size_t>(lane(known, i))];
  std::array<LaneVectors<Real>, 3> each;
  for (int i = 0; i < lanes<Real>; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      each[k].set(i, mesh.positions[corners[static_cast<std::size_t>(i)][k]]);
  return {each[0].all(), each[1].all(), each[2].all()};
}

/// The rays in the space of the mesh, of which each lane has hit an instance.
template <class Real>
Ray<Precise<Real>> object_rays(const Geometry& geometry, const Primitive& primitive,
                               const Ray<Real>& ray, const Real& instance, Mask<Real> here) {
  const Ray<Precise<Real>> exact{widen(ray.origin), widen(ray.direction)};
  if (primitive.space == 0 && !primitive.placed) return exact;
  if (primitive.space == 0)
    return {primitive.to_object.point(exact.origin), primitive.to_object.vector(exact.direction)};
  const Lines<Real> lines{RootRay<Real>(ray)};
  const Real known = select(here, instance, Real(0));
  LaneVectors<Real> origins, directions;
  for (int i = 0; i < lanes<Real>; ++i) {
    const Affine map = to_object(geometry, primitive, static_cast<std::int64_t>(lane(known, i)));
    const Line line = lines[static_cast<std::size_t>(i)];
    origins.set(i, map.point(line.origin));
    directions.set(i, map.vector(line.direction));
  }
  return {origins.all(), directions.all()};
}

/// Of lanes that have hit the mesh: the distance to the triangle's plane in double, where the mesh
/// is so large beside it that float's error exceeds the offset of new rays (tolerance::mesh_large).
/// Otherwise, and where the triangle is seen nearly edge on, the distance that float has found.
template <class Real>
[[gnu::flatten]] Real settled_distances(const Geometry& geometry, const Primitive& primitive,
                                        const Ray<Real>& ray, const Hit<Real>& hit,
                                        Mask<Real> here) {
  using P = Precise<Real>;
  using Doubles = std::array<double, static_cast<std::size_t>(lanes<Real>)>;
  const MeshIndex& mesh = *geometry.meshes[static_cast<std::size_t>(primitive.mesh)];
  const auto [a, b, c] = corners_of(mesh, hit.element, here);
  const auto [o, d] = object_rays(geometry, primitive, ray, hit.instance, here);
  const P per_unit(1 / mesh.unit);
  const auto measured = [&, middle = static_cast<Vec3<P>>(mesh.middle)](const Vec3<P>& p) {
    return (p - middle) * per_unit;
  };
  const Vec3<P> first = measured(a), direction = d * per_unit;
  const Vec3<P> n = cross(measured(b) - first, measured(c) - first);
  Doubles exact, rate;
  store(dot(n, first - measured(o)) / dot(n, direction), exact.data());
  store(P(1) / length(direction), rate.data());
  std::array<LaneOf<Real>, static_cast<std::size_t>(lanes<Real>)> t;
  store(hit.t, t.data());
  for (std::size_t i = 0; i < t.size(); ++i) {
    const bool settles = t[i] < tolerance::mesh_large * rate[i] && exact[i] > 0 &&
                         std::fabs(exact[i] - t[i]) < tolerance::mesh_settled * rate[i];
    t[i] = settles ? static_cast<LaneOf<Real>>(exact[i]) : t[i];
  }
  return tia::load<Real>(t.data());
}

}  // namespace detail

/// Settles the distances of hits on meshes. Called after the search: there all distances are
/// float's, so that the order in which things are tried does not matter.
template <class Real>
void settle_distances(const World& world, const Ray<Real>& ray, Mask<Real> active, Hit<Real>& hit) {
  if (world.of_objects->meshes.empty()) return;
  const Hit<Real> found = hit;
  for_each_winner(found, active, [&](int primitive, Mask<Real> here) {
    const Geometry& geometry = world.geometry_of(primitive);
    const Primitive& own = geometry.primitive(primitive);
    if (own.mesh < 0) return;
    if (own.space == 0 && !own.placed) {
      const MeshIndex& mesh = *geometry.meshes[static_cast<std::size_t>(own.mesh)];
      // A quick test that passes all that is settled.
      here = here && found.t < Real(static_cast<float>(mesh.unit));
      if (!any(here)) return;
    }
    const Real t = detail::settled_distances(geometry, own, ray, found, here);
    hit.t = select(here, t, hit.t);
  });
}

}  // namespace tia
