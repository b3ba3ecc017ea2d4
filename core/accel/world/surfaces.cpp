// The surface where rays hit a primitive: its normals and coordinates there, lane by lane, or eight
// lanes at once where the primitive's form can. What textures say of it is textures.cpp's.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "core/accel/mesh/mesh_point.h"
#include "core/accel/world/trace.h"

namespace tia {
namespace {

MeshPoint mesh_point(const Geometry& geometry, const Primitive& primitive, const Vec3d& local,
                     int element) {
  return point_of(*geometry.meshes[static_cast<std::size_t>(primitive.mesh)],
                  static_cast<std::size_t>(element), local);
}

}  // namespace

Normals normals_at(const World& world, const Vec3d& p, int primitive, int element,
                   std::int64_t instance) {
  const Geometry& geometry = world.geometry_of(primitive);
  const Primitive& own = geometry.primitive(primitive);
  const Affine map = to_object(geometry, own, instance);
  const Vec3d local = map.point(p);
  // Normals are transformed by the inverse transpose.
  const auto outwards = [&](const Vec3d& n) { return normalize(map.row(own.inverted ? -n : n)); };
  if (own.mesh >= 0) {
    // If the mesh has normals, they define its outer side. Source: pbrt-v4, Triangle.
    const MeshPoint at = mesh_point(geometry, own, local, element);
    const Vec3d n = outwards(at.n), ng = outwards(at.ng);
    return {n, dot(n, ng) < 0 ? -ng : ng};
  }
  const Vec3d n = outwards(
      std::visit([&](const auto& form) { return normal(form, local, element); }, own.form));
  return {n, n};
}

Vec2d uv_at(const World& world, const Vec3d& p, int primitive, int element, std::int64_t instance) {
  const Geometry& geometry = world.geometry_of(primitive);
  const Primitive& own = geometry.primitive(primitive);
  const Vec3d local = to_object(geometry, own, instance).point(p);
  if (own.mesh >= 0) return mesh_point(geometry, own, local, element).uv;
  return std::visit([&](const auto& form) { return uv(form, local, element); }, own.form);
}

namespace {

/// SurfaceLanes: points and normals of a packet in arrays, which are filled lane by lane.
template <class Real>
class SurfaceLanes {
 public:
  void set(std::size_t lane, const Vec3d& p, const Normals& at_p) {
    const auto& [n_of, ng] = at_p;
    const double all[] = {p.x, p.y, p.z, n_of.x, n_of.y, n_of.z, ng.x, ng.y, ng.z};
    for (std::size_t k = 0; k < 9; ++k) parts_[k][lane] = static_cast<LaneOf<Real>>(all[k]);
  }
  SurfacePoint<Real> all() const { return {vector(0), vector(3), vector(6), {}}; }

 private:
  Vec3<Real> vector(std::size_t k) const {
    return {load<Real>(parts_[k].data()), load<Real>(parts_[k + 1].data()),
            load<Real>(parts_[k + 2].data())};
  }

  std::array<std::array<LaneOf<Real>, static_cast<std::size_t>(lanes<Real>)>, 9> parts_{};
};

}  // namespace

template <class Real>
SurfacePoint<Real> surface_by_lanes(const World& world, const Ray<Real>& ray, const Hit<Real>& hit,
                                    int primitive, Mask<Real> here) {
  SurfaceLanes<Real> all;
  const Lines<Real> lines{RootRay<Real>(ray)};
  for (unsigned left = bits(here); left != 0; left &= left - 1) {
    const int i = std::countr_zero(left);
    const auto at = static_cast<std::size_t>(i);
    const Vec3d p = lines[at].at(lane(hit.t, i));
    all.set(at, p,
            normals_at(world, p, primitive, static_cast<int>(lane(hit.element, i)),
                       static_cast<std::int64_t>(lane(hit.instance, i))));
  }
  return all.all();
}

template <class Real>
SurfacePoint<Real> surface_in_eights(const Primitive& primitive, const Ray<Real>& ray,
                                     const Real& t) {
  constexpr auto n = static_cast<std::size_t>(lanes<Real>);
  static_assert(n % 8 == 0);
  const Lines<Real> lines{RootRay<Real>(ray)};
  std::array<double, n> distances;
  store(widen(t), distances.data());
  SurfaceLanes<Real> all;
  for (std::size_t first = 0; first < n; first += 8) {
    const Vec3<Octet> p = lines.eight(first).at(Octet::load_unaligned(&distances[first]));
    const Vec3<Octet> own = normals_of_eight(primitive, primitive.to_object.point(p));
    const Vec3<Octet> out = normalize(primitive.to_object.row(primitive.inverted ? -own : own));
    for (int i = 0; i < 8; ++i) {
      const Vec3d one{lane(out.x, i), lane(out.y, i), lane(out.z, i)};
      all.set(first + static_cast<std::size_t>(i), {lane(p.x, i), lane(p.y, i), lane(p.z, i)},
              {one, one});
    }
  }
  return all.all();
}

template <class Real>
SurfacePoint<Real> copied_ball_surface(const Ball& ball, const InstanceGrid& grid,
                                       const Ray<Real>& ray, const Hit<Real>& hit) {
  using P = Precise<Real>;
  constexpr auto n = static_cast<std::size_t>(lanes<Real>);
  std::array<std::array<double, n>, 3> centers{};
  for (std::size_t i = 0; i < n; ++i) {
    const auto instance = static_cast<std::int64_t>(lane(hit.instance, static_cast<int>(i)));
    const Vec3d center = ball.sphere.center + grid.offset(instance);
    centers[0][i] = center.x, centers[1][i] = center.y, centers[2][i] = center.z;
  }
  const RootRay<Real> root(ray);
  const Vec3<P> p = root.origin + root.direction * widen(hit.t);
  const Vec3<P> out =
      grid.to_group.point(p) -
      Vec3<P>{load<P>(centers[0].data()), load<P>(centers[1].data()), load<P>(centers[2].data())};
  const auto narrowed = [](const Vec3<P>& v) -> Vec3<Real> {
    return {narrow<Real>(v.x), narrow<Real>(v.y), narrow<Real>(v.z)};
  };
  const Vec3<Real> normal = normalize(narrowed(grid.to_group.row(out)));
  return {narrowed(p), normal, normal, {}};
}

#define TIA_SURFACES(Real)                                                                       \
  template SurfacePoint<Real> copied_ball_surface(const Ball&, const InstanceGrid&,              \
                                                  const Ray<Real>&, const Hit<Real>&);           \
  template SurfacePoint<Real> surface_by_lanes(const World&, const Ray<Real>&, const Hit<Real>&, \
                                               int, Mask<Real>);
TIA_SURFACES(Wide)
TIA_SURFACES(float)
TIA_SURFACES(double)
#undef TIA_SURFACES
template SurfacePoint<Wide> surface_in_eights(const Primitive&, const Ray<Wide>&, const Wide&);

}  // namespace tia
