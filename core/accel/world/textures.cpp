// What textures say of the surface where rays hit a primitive: its colours, its material's numbers
// and how its normals are bent, lane by lane.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "core/accel/mesh/mesh_point.h"
#include "core/accel/world/trace.h"
#include "core/accel/world/winners.h"

namespace tia {
namespace {

// Calls visit(lane, line, t, to_object) where the lanes of `here` hit a primitive.
template <class Real, class Visit>
void each_hit(const World& world, const Ray<Real>& ray, const Hit<Real>& hit, int primitive,
              Mask<Real> here, Visit visit) {
  const Geometry& geometry = world.geometry_of(primitive);
  const Lines<Real> lines{RootRay<Real>(ray)};
  for (unsigned left = bits(here); left != 0; left &= left - 1) {
    const int i = std::countr_zero(left);
    const auto at = static_cast<std::size_t>(i);
    const auto instance = static_cast<std::int64_t>(lane(hit.instance, i));
    visit(at, lines[at], static_cast<double>(lane(hit.t, i)),
          to_object(geometry, geometry.primitive(primitive), instance));
  }
}

double blur_of(const Line& line, double t, const Vec3d& p, const Affine& map) {
  const double reach = std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z), t});
  return tolerance::texture_point * reach * length(map.vector(line.direction));
}

// What a cone covers of the mesh' uvs, where it is `width` wide: it meets the triangle's plane in
// an ellipse that is longer by the slant, and all of it counts. Source: JCGT 10(1), 2021 (rgba_at),
// (1) and (2), with areas in the world, of which a triangle's is its own by the map's determinant.
void set_footprint(const MeshTexturePoint& from, const Line& line, double width, const Affine& map,
                   TexturePoint& to) {
  if (!(width > 0)) return;
  const double scale = std::fabs(map.determinant());
  const double area = length(map.row(from.area)) / scale;
  const double seen = std::fabs(dot(from.area, map.vector(line.direction))) / scale;
  for (std::size_t set = 0; set < 2; ++set)
    to.footprint[set] = width * (std::sqrt(from.uv_area[set] * area) / seen);
}

TexturePoint mesh_texture_point(const MeshIndex& mesh, std::size_t triangle, const Line& line,
                                double t, double width, const Affine& map) {
  const Vec3d p = line.at(t);
  TexturePoint to;
  to.p = map.point(p);
  to.blur = blur_of(line, t, p, map);
  const MeshTexturePoint from = texture_point_of(mesh, triangle, to.p);
  to.uv = from.uv;
  to.color = from.color;
  set_footprint(from, line, width, map, to);
  return to;
}

// Calls visit(lane, point) where the lanes of `here` hit a textured primitive, with its surface
// coordinates where they are wanted.
template <class Real, class Visit>
void each_texture_point(const World& world, const Ray<Real>& ray, const Hit<Real>& hit,
                        int primitive, Mask<Real> here, bool with_uv, const Real& width,
                        Visit visit) {
  const Geometry& geometry = world.geometry_of(primitive);
  const Primitive& own = geometry.primitive(primitive);
  each_hit(
      world, ray, hit, primitive, here,
      [&](std::size_t at, const Line& line, double t, const Affine& map) {
        const int i = static_cast<int>(at), element = static_cast<int>(lane(hit.element, i));
        if (with_uv && own.mesh >= 0)
          return visit(at, mesh_texture_point(*geometry.meshes[static_cast<std::size_t>(own.mesh)],
                                              static_cast<std::size_t>(element), line, t,
                                              static_cast<double>(lane(width, i)), map));
        const Vec3d p = line.at(t);
        TexturePoint point;
        point.p = map.point(p);
        point.blur = blur_of(line, t, p, map);
        if (with_uv)
          point.uv[0] =
              std::visit([&](const auto& form) { return uv(form, point.p, element); }, own.form);
        visit(at, point);
      });
}

// The colour of a mesh with colours or, of another primitive, white.
Vec3d mesh_color(const Geometry& geometry, const Primitive& own, int element, const Vec3d& local) {
  if (!own.colored) return {1, 1, 1};
  const std::array<double, 4> rgba = color_of(*geometry.meshes[static_cast<std::size_t>(own.mesh)],
                                              static_cast<std::size_t>(element), local);
  return {rgba[0], rgba[1], rgba[2]};
}

}  // namespace

template <class Real>
Vec3<Real> texture_colors(const World& world, const Ray<Real>& ray, const Hit<Real>& hit,
                          int primitive, Mask<Real> here) {
  constexpr auto n = static_cast<std::size_t>(lanes<Real>);
  const Geometry& geometry = world.geometry_of(primitive);
  const Primitive& own = geometry.primitive(primitive);
  const int number = geometry.shading_of(primitive).texture;
  const TextureForm* texture =
      number < 0 ? nullptr : &geometry.textures[static_cast<std::size_t>(number)];
  std::array<std::array<LaneOf<Real>, n>, 3> rgb{};
  each_texture_point(world, ray, hit, primitive, here,
                     texture != nullptr && std::holds_alternative<ImageForm>(texture->kind),
                     Real(0), [&](std::size_t at, const TexturePoint& point) {
                       const int element =
                           static_cast<int>(lane(hit.element, static_cast<int>(at)));
                       Vec3d color = mesh_color(geometry, own, element, point.p);
                       if (texture != nullptr)
                         color = color * color_at(*texture, point.p, point.uv[0], point.blur);
                       const double channels[] = {color.x, color.y, color.z};
                       for (std::size_t k = 0; k < 3; ++k)
                         rgb[k][at] = static_cast<LaneOf<Real>>(channels[k]);
                     });
  return {load<Real>(rgb[0].data()), load<Real>(rgb[1].data()), load<Real>(rgb[2].data())};
}

template <class Real>
void take_numbers(const World& world, const Ray<Real>& ray, const Hit<Real>& hit, int primitive,
                  Mask<Real> here, const Real& width, LaneNumbers<Real>& numbers) {
  const Geometry& geometry = world.geometry_of(primitive);
  const PrincipledForm& form =
      geometry.forms[static_cast<std::size_t>(geometry.shading_of(primitive).form)];
  if (!numbers) numbers.emplace();
  each_texture_point(
      world, ray, hit, primitive, here, wants_uv(form), width,
      [&](std::size_t at, const TexturePoint& point) { (*numbers)[at] = numbers_at(form, point); });
}

namespace {

// A normal of a mesh in the world, bent by its map. A mirrored mesh is the mirror image.
Vec3d bent(const PrincipledMaps& maps, const MeshIndex& mesh, std::size_t triangle,
           const TexturePoint& at, const Affine& map, const Vec3d& n) {
  const Vec3d local = point_of(mesh, triangle, at.p).n;
  const MeshTangent own = tangent_of(mesh, triangle, *maps.normal, at.p, local);
  const Vec3d given = map.inverse().vector(own.t);
  const Vec3d t = normalize(given - n * dot(given, n));
  const double sign = map.determinant() < 0 ? -own.sign : own.sign;
  const Vec3d m = mapped_normal(maps, at);
  return normalize(t * m.x + cross(n, t) * (sign * m.y) + n * m.z);
}

}  // namespace

template <class Real>
void bend_normals(const World& world, const Ray<Real>& ray, const Hit<Real>& hit, int primitive,
                  Mask<Real> here, const Real& width, SurfacePoint<Real>& at) {
  const Geometry& geometry = world.geometry_of(primitive);
  const auto form = static_cast<std::size_t>(geometry.shading_of(primitive).form);
  const PrincipledMaps& maps = *geometry.forms[form].maps;
  const MeshIndex& mesh =
      *geometry.meshes[static_cast<std::size_t>(geometry.primitive(primitive).mesh)];
  constexpr auto n = static_cast<std::size_t>(lanes<Real>);
  std::array<std::array<LaneOf<Real>, n>, 3> bent_n{};
  each_hit(world, ray, hit, primitive, here,
           [&](std::size_t k, const Line& line, double t, const Affine& map) {
             const int i = static_cast<int>(k);
             const auto triangle = static_cast<std::size_t>(lane(hit.element, i));
             const TexturePoint point = mesh_texture_point(
                 mesh, triangle, line, t, static_cast<double>(lane(width, i)), map);
             const double side = (bits(at.front) >> i & 1U) != 0 ? 1 : -1;
             const Vec3d outward = Vec3d{lane(at.n.x, i), lane(at.n.y, i), lane(at.n.z, i)} * side;
             const Vec3d made = bent(maps, mesh, triangle, point, map, outward) * side;
             bent_n[0][k] = static_cast<LaneOf<Real>>(made.x);
             bent_n[1][k] = static_cast<LaneOf<Real>>(made.y);
             bent_n[2][k] = static_cast<LaneOf<Real>>(made.z);
           });
  at.n = select(
      here,
      {load<Real>(bent_n[0].data()), load<Real>(bent_n[1].data()), load<Real>(bent_n[2].data())},
      at.n);
}

#define TIA_TEXTURES(Real)                                                                      \
  template Vec3<Real> texture_colors(const World&, const Ray<Real>&, const Hit<Real>&, int,     \
                                     Mask<Real>);                                               \
  template void take_numbers(const World&, const Ray<Real>&, const Hit<Real>&, int, Mask<Real>, \
                             const Real&, LaneNumbers<Real>&);                                  \
  template void bend_normals(const World&, const Ray<Real>&, const Hit<Real>&, int, Mask<Real>, \
                             const Real&, SurfacePoint<Real>&);
TIA_TEXTURES(Wide)
TIA_TEXTURES(float)
TIA_TEXTURES(double)
#undef TIA_TEXTURES

}  // namespace tia
