// What textures say of the surface where rays hit a primitive: its colours, its material's numbers
// and how its normals are bent, lane by lane.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "core/accel/mesh/mesh_point.h"
#include "core/accel/world/bending.h"
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
// an ellipse that is longer by the slant, and all of it counts. Source: JCGT 10(1), 2021
// (lookup_of), (1) and (2), with areas in the world, of which a triangle's is its own by the map's
// determinant.
void set_footprint(const MeshTexturePoint& from, const Vec3d& whole, const Line& line, double width,
                   const Affine& map, TexturePoint& to) {
  if (!(width > 0)) return;
  const double scale = std::fabs(map.determinant());
  const double area = length(map.row(whole)) / scale;
  const double seen = std::fabs(dot(whole, map.vector(line.direction))) / scale;
  for (std::size_t set = 0; set < 2; ++set)
    to.footprint[set] = set == 1 && from.uv_area[1] == from.uv_area[0]
                            ? to.footprint[0]
                            : width * (std::sqrt(from.uv_area[set] * area) / seen);
}

// Calls visit(lane, point, triangle point, line, map) where the lanes of `here` hit a mesh with
// textures that are looked up by uvs.
template <class Real, class Visit>
void each_mesh_texture_point(const World& world, const Ray<Real>& ray, const Hit<Real>& hit,
                             int primitive, Mask<Real> here, const Real& width, Visit visit) {
  const Geometry& geometry = world.geometry_of(primitive);
  const MeshIndex& mesh =
      *geometry.meshes[static_cast<std::size_t>(geometry.primitive(primitive).mesh)];
  each_hit(world, ray, hit, primitive, here,
           [&](std::size_t lane_number, const Line& line, double t, const Affine& map) {
             const int i = static_cast<int>(lane_number);
             const Vec3d p = line.at(t);
             TexturePoint to;
             to.p = map.point(p);
             to.blur = blur_of(line, t, p, map);
             const TrianglePoint at(mesh, static_cast<std::size_t>(lane(hit.element, i)), to.p);
             const MeshTexturePoint from = texture_point_of(at);
             to.uv = from.uv;
             to.color = from.color;
             set_footprint(from, at.whole, line, static_cast<double>(lane(width, i)), map, to);
             visit(lane_number, to, at, map);
           });
}

// Calls visit(lane, point) where the lanes of `here` hit a textured primitive, with its surface
// coordinates where they are wanted.
template <class Real, class Visit>
void each_texture_point(const World& world, const Ray<Real>& ray, const Hit<Real>& hit,
                        int primitive, Mask<Real> here, bool with_uv, Visit visit) {
  const Primitive& own = world.primitive(primitive);
  if (with_uv && own.mesh >= 0)
    return each_mesh_texture_point(
        world, ray, hit, primitive, here, Real(0),
        [&](std::size_t at, const TexturePoint& point, const auto&...) { visit(at, point); });
  each_hit(world, ray, hit, primitive, here,
           [&](std::size_t at, const Line& line, double t, const Affine& map) {
             const int element = static_cast<int>(lane(hit.element, static_cast<int>(at)));
             const Vec3d p = line.at(t);
             TexturePoint point;
             point.p = map.point(p);
             point.blur = blur_of(line, t, p, map);
             if (with_uv)
               point.uv[0] = std::visit(
                   [&](const auto& form) { return uv(form, point.p, element); }, own.form);
             visit(at, point);
           });
}

// The colour of a mesh with colours or, of another primitive, white.
Vec3d mesh_color(const Geometry& geometry, const Primitive& own, int element, const Vec3d& local) {
  if (!own.colored) return {1, 1, 1};
  const std::array<double, 4> rgba = color_of({*geometry.meshes[static_cast<std::size_t>(own.mesh)],
                                               static_cast<std::size_t>(element), local});
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
                     [&](std::size_t at, const TexturePoint& point) {
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

namespace {

template <class Real>
const PrincipledForm& form_in(const World& world, int primitive, LaneNumbers<Real>& numbers) {
  if (!numbers) numbers.emplace();
  const Geometry& geometry = world.geometry_of(primitive);
  return geometry.forms[static_cast<std::size_t>(geometry.shading_of(primitive).form)];
}

}  // namespace

template <class Real>
void take_numbers(const World& world, const Ray<Real>& ray, const Hit<Real>& hit, int primitive,
                  Mask<Real> here, LaneNumbers<Real>& numbers) {
  const PrincipledForm& form = form_in<Real>(world, primitive, numbers);
  each_texture_point(world, ray, hit, primitive, here, wants_uv(form),
                     [&](std::size_t at, const TexturePoint& point) {
                       TextureReader reader(point);
                       (*numbers)[at] = numbers_at(form, reader);
                     });
}

template <class Real>
void take_textures(const World& world, const Ray<Real>& ray, const Hit<Real>& hit, int primitive,
                   Mask<Real> here, const Real& width, LaneTextures<Real>& textures,
                   SurfacePoint<Real>& at) {
  const PrincipledForm& form = form_in<Real>(world, primitive, textures.numbers);
  if (!form.maps || world.primitive(primitive).mesh < 0)
    return take_numbers(world, ray, hit, primitive, here, textures.numbers);
  Bending<Real> bending(*form.maps, at);
  const bool bends = bending.bends();
  each_mesh_texture_point(world, ray, hit, primitive, here, width,
                          [&](std::size_t i, const TexturePoint& point,
                              const TrianglePoint& triangle, const Affine& map) {
                            TextureReader reader(point);
                            PrincipledNumbers& numbers = (*textures.numbers)[i];
                            numbers = numbers_at(form, reader);
                            if (bends)
                              bending.bend(static_cast<int>(i), reader, triangle, map, numbers);
                          });
  if (bends) bending.store(here, textures, at);
}

#define TIA_TEXTURES(Real)                                                                       \
  template Vec3<Real> texture_colors(const World&, const Ray<Real>&, const Hit<Real>&, int,      \
                                     Mask<Real>);                                                \
  template void take_numbers(const World&, const Ray<Real>&, const Hit<Real>&, int, Mask<Real>,  \
                             LaneNumbers<Real>&);                                                \
  template void take_textures(const World&, const Ray<Real>&, const Hit<Real>&, int, Mask<Real>, \
                              const Real&, LaneTextures<Real>&, SurfacePoint<Real>&);
TIA_TEXTURES(Wide)
TIA_TEXTURES(float)
TIA_TEXTURES(double)
#undef TIA_TEXTURES

}  // namespace tia
