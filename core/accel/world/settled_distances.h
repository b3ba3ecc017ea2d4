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
  LaneVectors() = default;
  explicit LaneVectors(const Vec3<Precise<Real>>& all) {
    store(all.x, x_.data()), store(all.y, y_.data()), store(all.z, z_.data());
  }
  void set(int lane, const Vec3d& v) {
    const auto i = static_cast<std::size_t>(lane);
    x_[i] = v.x, y_[i] = v.y, z_[i] = v.z;
  }
  Vec3d one(int lane) const {
    const auto i = static_cast<std::size_t>(lane);
    return {x_[i], y_[i], z_[i]};
  }
  Vec3<Precise<Real>> all() const {
    return {tia::load<Precise<Real>>(x_.data()), tia::load<Precise<Real>>(y_.data()),
            tia::load<Precise<Real>>(z_.data())};
  }

 private:
  std::array<double, static_cast<std::size_t>(lanes<Real>)> x_{}, y_{}, z_{};
};

/// MeshHits: what lanes have hit on meshes, each in the object space of its mesh.
template <class Real>
class MeshHits {
 public:
  using P = Precise<Real>;

  explicit MeshHits(const Ray<Real>& ray)
      : origins_(widen(ray.origin)), directions_(widen(ray.direction)) {}

  /// Adds the lanes of `here`, which have hit the primitive.
  void add(const Geometry& geometry, const Primitive& primitive, const Hit<Real>& hit,
           Mask<Real> here) {
    const MeshIndex& mesh = *geometry.meshes[static_cast<std::size_t>(primitive.mesh)];
    for_each_lane(here, [&](int i) {
      const MeshIndex::Plane& plane = mesh.planes[static_cast<std::size_t>(lane(hit.element, i))];
      normals_.set(i, plane.n);
      offsets_[static_cast<std::size_t>(i)] = plane.d;
      middles_.set(i, mesh.middle);
      per_unit_[static_cast<std::size_t>(i)] = 1 / mesh.unit;
    });
    if (primitive.space != 0 || primitive.placed) map(geometry, primitive, hit, here);
    here_ = here_ || here;
  }

  /// The distances of the hit: of these lanes to their triangles' planes in double, where the mesh
  /// is so large beside it that float's error exceeds the offset of new rays
  /// (tolerance::mesh_large). Otherwise, and where the triangle is seen nearly edge on, and in the
  /// other lanes, those that float has found.
  [[gnu::flatten]] Real settled(const Real& found) const {
    if (!any(here_)) return found;
    const P per_unit = tia::load<P>(per_unit_.data());
    const Vec3<P> middle = middles_.all();
    const auto measured = [&](const Vec3<P>& p) { return (p - middle) * per_unit; };
    const Vec3<P> n = normals_.all(), direction = directions_.all() * per_unit;
    std::array<double, count> exact, rate;
    const P before = tia::load<P>(offsets_.data()) - dot(n, measured(origins_.all()));
    store(before / dot(n, direction), exact.data());
    store(P(1) / length(direction), rate.data());
    std::array<LaneOf<Real>, count> t;
    store(found, t.data());
    for (std::size_t i = 0; i < count; ++i) {
      const bool settles = t[i] < tolerance::mesh_large * rate[i] && exact[i] > 0 &&
                           std::fabs(exact[i] - t[i]) < tolerance::mesh_settled * rate[i];
      t[i] = settles ? static_cast<LaneOf<Real>>(exact[i]) : t[i];
    }
    return select(here_, tia::load<Real>(t.data()), found);
  }

 private:
  static constexpr auto count = static_cast<std::size_t>(lanes<Real>);

  // Takes their rays to the object space, which for every instance is another.
  void map(const Geometry& geometry, const Primitive& primitive, const Hit<Real>& hit,
           Mask<Real> here) {
    for_each_lane(here, [&](int i) {
      const Affine own =
          to_object(geometry, primitive, static_cast<std::int64_t>(lane(hit.instance, i)));
      origins_.set(i, own.point(origins_.one(i)));
      directions_.set(i, own.vector(directions_.one(i)));
    });
  }

  Mask<Real> here_ = Real(0) > Real(0);
  LaneVectors<Real> normals_;  // of the planes, with their offsets
  std::array<double, count> offsets_{};
  LaneVectors<Real> origins_, directions_;  // of rays that have hit nothing, too
  LaneVectors<Real> middles_;
  std::array<double, count> per_unit_{};
};

}  // namespace detail

/// Settles the distances of hits on meshes. Called after the search: there all distances are
/// float's, so that the order in which things are tried does not matter.
template <class Real>
void settle_distances(const World& world, const Ray<Real>& ray, Mask<Real> active, Hit<Real>& hit) {
  if (world.of_objects->meshes.empty()) return;
  detail::MeshHits<Real> hits(ray);
  for_each_winner(hit, active, [&](int primitive, Mask<Real> here) {
    const Geometry& geometry = world.geometry_of(primitive);
    const Primitive& own = geometry.primitive(primitive);
    if (own.mesh < 0) return;
    if (own.space == 0 && !own.placed) {
      const MeshIndex& mesh = *geometry.meshes[static_cast<std::size_t>(own.mesh)];
      // A quick test that passes all that is settled.
      here = here && hit.t < Real(static_cast<float>(mesh.unit));
      if (!any(here)) return;
    }
    hits.add(geometry, own, hit, here);
  });
  hit.t = hits.settled(hit.t);
}

}  // namespace tia
