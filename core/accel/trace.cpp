#include "core/accel/trace.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/accel/search.h"

namespace tia {

namespace {

Affine to_object(const Geometry& geometry, const Part& part, std::int64_t copy) {
  return part.space == 0 ? part.to_object : part.to_object * geometry.to_space(part.space, copy);
}

// The distance that double finds by the plane of the triangle that is hit, where the mesh is so
// large beside it that an offset from the surface (offset_of) is lost in what float keeps of it;
// else, and where the triangle is seen edge on, the one that is there.
double settled_distance(const Geometry& geometry, const Part& part, const Line& line,
                        std::size_t triangle, std::int64_t copy, double t) {
  const MeshIndex& mesh = *geometry.meshes[static_cast<std::size_t>(part.mesh)];
  const Affine map = to_object(geometry, part, copy);
  const Vec3d way = map.vector(line.direction) * (1 / mesh.unit);
  const double rate = 1 / length(way);
  if (!(t < large_mesh * rate)) return t;
  const double exact = mesh.plane_distance(triangle, {mesh.measured(map.point(line.origin)), way});
  return exact > 0 && std::fabs(exact - t) < 0x1p-12 * rate ? exact : t;
}

// After the search, which compares what float has found: so it does not matter what comes first.
template <class Real>
void settle_distances(const World& world, const Ray<Real>& ray, Mask<Real> active, Hit<Real>& hit) {
  if (world.of_objects->meshes.empty()) return;
  const Hit<Real> found = hit;
  for_each_winner(found, active, [&](int part, Mask<Real> here) {
    const Geometry& geometry = world.geometry_of(part);
    const Part& own = geometry.part(part);
    if (own.mesh < 0) return;
    if (own.space == 0 && !own.placed) {
      const MeshIndex& mesh = *geometry.meshes[static_cast<std::size_t>(own.mesh)];
      here = here && found.t < Real(static_cast<float>(mesh.unit));  // wider than it is asked below
      if (!any(here)) return;
    }
    std::array<LaneOf<Real>, static_cast<std::size_t>(lanes<Real>)> t;
    store(found.t, t.data());
    const Lines<Real> lines{RootRay<Real>(ray)};
    for (unsigned left = bits(here); left != 0; left &= left - 1) {
      const int i = std::countr_zero(left);
      LaneOf<Real>& at = t[static_cast<std::size_t>(i)];
      at = static_cast<LaneOf<Real>>(settled_distance(
          geometry, own, lines[static_cast<std::size_t>(i)],
          static_cast<std::size_t>(lane(found.element, i)),
          static_cast<std::int64_t>(lane(found.copy, i)), static_cast<double>(at)));
    }
    hit.t = select(here, load<Real>(t.data()), hit.t);
  });
}

template <class Real>
Hit<Real> nearest(const World& world, const Ray<Real>& ray, Mask<Real> active, Nearest<Real> query,
                  Effort& effort) {
  search(world, ray, active, query, effort);
  if constexpr (!std::is_same_v<Real, double>) settle_distances(world, ray, active, query.hit);
  return query.hit;
}

}  // namespace

template <class Real>
Hit<Real> closest_hit(const World& world, const Ray<Real>& ray, Mask<Real> active, Effort& effort) {
  return nearest<Real>(world, ray, active, {}, effort);
}

template <class Real>
Mask<Real> occluded(const World& world, const Ray<Real>& ray, const Real& t_max, const Lamp& lamp,
                    Mask<Real> active, Effort& effort) {
  AnyHit<Real> query{t_max, lamp.part, lamp.copy};
  search(world, ray, active, query, effort);
  return query.blocked();
}

namespace {

// Goes from surface to surface, the lamp's own left out, as far as t_max and as long as lanes want
// to: visit(hit, lanes) tells which of them do. The offset behind each surface is as far as a
// shadow ray's in front of its own.
template <class Real, class Visit>
void walk(const World& world, const Ray<Real>& ray, const Real& t_max, const Lamp& lamp,
          Mask<Real> going, Effort& effort, Visit visit) {
  Real done(0);
  while (any(going)) {
    const Vec3<Real> from = ray.at(done);
    const Nearest<Real> query{{}, lamp.part, lamp.copy};
    const Hit<Real> hit = nearest<Real>(world, {from, ray.direction}, going, query, effort);
    const Real t = done + hit.t;
    going = visit(hit, going && t < t_max);
    done = select(going, t + offset_of(t, ray.at(t)), done);
  }
}

// What the lanes' hits let through.
template <class Real>
Real transmissions(const World& world, const Hit<Real>& hit, Mask<Real> met) {
  Real share(0);
  for_each_winner(hit, met, [&](int part, Mask<Real> here) {
    share = select(here, lift<Real>(world.matter_of(part).transmission), share);
  });
  return share;
}

}  // namespace

template <class Real>
Real transmitted(const World& world, const Ray<Real>& ray, const Real& t_max, const Lamp& lamp,
                 Mask<Real> active, Effort& effort) {
  Real share(1);
  const auto take = [&](const Hit<Real>& hit, Mask<Real> met) -> Mask<Real> {
    share = select(met, share * transmissions(world, hit, met), share);
    return met && share > Real(0);
  };
  walk(world, ray, t_max, lamp, active, effort, take);
  return share;
}

int blocking_part(const World& world, const Ray<float>& ray, float t_max, const Lamp& lamp,
                  bool transparent, Effort& effort) {
  int blocking = -1;
  walk(world, ray, t_max, lamp, true, effort, [&](const Hit<float>& hit, bool met) {
    if (!met) return false;
    const int part = static_cast<int>(hit.part);
    if (transparent && world.matter_of(part).transmission == 1) return true;
    blocking = part;
    return false;
  });
  return blocking;
}

namespace {

MeshPoint mesh_point(const Geometry& geometry, const Part& part, const Vec3d& local, int element) {
  return point_of(*geometry.meshes[static_cast<std::size_t>(part.mesh)],
                  static_cast<std::size_t>(element), local);
}

}  // namespace

Normals normals_at(const World& world, const Vec3d& p, int part, int element, std::int64_t copy) {
  const Geometry& geometry = world.geometry_of(part);
  const Part& own = geometry.part(part);
  const Affine map = to_object(geometry, own, copy);
  const Vec3d local = map.point(p);
  // Normals are carried out by the inverse transpose.
  const auto outwards = [&](const Vec3d& n) { return normalize(map.row(own.inverted ? -n : n)); };
  if (own.mesh >= 0) {
    const MeshPoint at = mesh_point(geometry, own, local, element);
    return {outwards(at.n), outwards(at.ng)};
  }
  const Vec3d n = outwards(
      std::visit([&](const auto& form) { return normal(form, local, element); }, own.form));
  return {n, n};
}

Vec2d uv_at(const World& world, const Vec3d& p, int part, int element, std::int64_t copy) {
  const Geometry& geometry = world.geometry_of(part);
  const Part& own = geometry.part(part);
  const Vec3d local = to_object(geometry, own, copy).point(p);
  if (own.mesh >= 0) return mesh_point(geometry, own, local, element).uv;
  return std::visit([&](const auto& form) { return uv(form, local, element); }, own.form);
}

template <class Real>
SurfacePoint<Real> surface_by_lanes(const World& world, const Ray<Real>& ray, const Hit<Real>& hit,
                                    int part, Mask<Real> here) {
  constexpr auto n = static_cast<std::size_t>(lanes<Real>);
  std::array<std::array<LaneOf<Real>, n>, 9> parts{};
  const Lines<Real> lines{RootRay<Real>(ray)};
  for (unsigned left = bits(here); left != 0; left &= left - 1) {
    const int i = std::countr_zero(left);
    const auto at = static_cast<std::size_t>(i);
    const Vec3d p = lines[at].at(lane(hit.t, i));
    const Normals at_p = normals_at(world, p, part, static_cast<int>(lane(hit.element, i)),
                                    static_cast<std::int64_t>(lane(hit.copy, i)));
    const Vec3d &n_of = at_p.n, &ng = at_p.ng;
    const double all[] = {p.x, p.y, p.z, n_of.x, n_of.y, n_of.z, ng.x, ng.y, ng.z};
    for (std::size_t k = 0; k < 9; ++k) parts[k][at] = static_cast<LaneOf<Real>>(all[k]);
  }
  const auto vector = [&](std::size_t k) -> Vec3<Real> {
    return {load<Real>(parts[k].data()), load<Real>(parts[k + 1].data()),
            load<Real>(parts[k + 2].data())};
  };
  return {vector(0), vector(3), vector(6), {}};
}

template <class Real>
SurfacePoint<Real> copied_ball_surface(const Ball& ball, const Copies& grid, const Ray<Real>& ray,
                                       const Hit<Real>& hit) {
  using P = Precise<Real>;
  constexpr auto n = static_cast<std::size_t>(lanes<Real>);
  std::array<std::array<double, n>, 3> centers{};
  for (std::size_t i = 0; i < n; ++i) {
    const auto copy = static_cast<std::int64_t>(lane(hit.copy, static_cast<int>(i)));
    const Vec3d center = ball.sphere.center + grid.offset(copy);
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

template <class Real>
Vec3<Real> texture_colors(const World& world, const Ray<Real>& ray, const Hit<Real>& hit, int part,
                          Mask<Real> here) {
  constexpr auto n = static_cast<std::size_t>(lanes<Real>);
  const Geometry& geometry = world.geometry_of(part);
  const TextureForm& texture =
      geometry.textures[static_cast<std::size_t>(geometry.matter_of(part).texture)];
  const bool wants_uv = std::holds_alternative<ImageForm>(texture.kind);
  std::array<std::array<LaneOf<Real>, n>, 3> rgb{};
  const Lines<Real> lines{RootRay<Real>(ray)};
  for (unsigned left = bits(here); left != 0; left &= left - 1) {
    const int i = std::countr_zero(left);
    const auto at = static_cast<std::size_t>(i);
    const auto copy = static_cast<std::int64_t>(lane(hit.copy, i));
    const Line line = lines[at];
    const Vec3d p = line.at(lane(hit.t, i));
    const Affine map = to_object(geometry, geometry.part(part), copy);
    const Vec2d uv =
        wants_uv ? uv_at(world, p, part, static_cast<int>(lane(hit.element, i)), copy) : Vec2d{};
    // The point is off its surface along the ray, by the rounding of t and of what t is made of.
    const double reach = std::max(
        {std::fabs(p.x), std::fabs(p.y), std::fabs(p.z), static_cast<double>(lane(hit.t, i))});
    const double blur = 4e-6 * reach * length(map.vector(line.direction));
    const Vec3d color = color_at(texture, map.point(p), uv, blur);
    const double parts[] = {color.x, color.y, color.z};
    for (std::size_t k = 0; k < 3; ++k) rgb[k][at] = static_cast<LaneOf<Real>>(parts[k]);
  }
  return {load<Real>(rgb[0].data()), load<Real>(rgb[1].data()), load<Real>(rgb[2].data())};
}

// ---- the three scalars ----------------------------------------------------------------------

#define TIA_TRACE(Real)                                                                           \
  template Hit<Real> closest_hit(const World&, const Ray<Real>&, Mask<Real>, Effort&);            \
  template Mask<Real> occluded(const World&, const Ray<Real>&, const Real&, const Lamp&,          \
                               Mask<Real>, Effort&);                                              \
  template Real transmitted(const World&, const Ray<Real>&, const Real&, const Lamp&, Mask<Real>, \
                            Effort&);                                                             \
  template Vec3<Real> texture_colors(const World&, const Ray<Real>&, const Hit<Real>&, int,       \
                                     Mask<Real>);                                                 \
  template SurfacePoint<Real> copied_ball_surface(const Ball&, const Copies&, const Ray<Real>&,   \
                                                  const Hit<Real>&);                              \
  template SurfacePoint<Real> surface_by_lanes(const World&, const Ray<Real>&, const Hit<Real>&,  \
                                               int, Mask<Real>);
TIA_TRACE(Wide)
TIA_TRACE(float)
TIA_TRACE(double)
#undef TIA_TRACE

}  // namespace tia
