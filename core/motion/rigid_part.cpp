#include "core/motion/rigid_part.h"

#include <algorithm>
#include <cmath>

#include "core/math/deterministic.h"
#include "core/math/onb.h"
#include "core/motion/measure.h"
#include "core/motion/similarity.h"

namespace tia {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// Surface: triangles in the scene's space.
struct Surface {
  std::vector<Vec3d> points;
  Triangles triangles;
};

// A right-handed frame there whose y goes along an axis of some length.
Affine frame_along(const Vec3d& axis, const Vec3d& at) {
  const Vec3d y = normalize(axis);
  const Vec3d x = onb_around(y).u;
  return {x, y, cross(x, y), at};
}

Affine frame_at(const Vec3d& at) { return Affine::translation(at); }

// ---- shapes that the solver has, wherever they are --------------------------------------------

using MaybePart = std::optional<RigidPart>;

MaybePart part(const Sphere& sphere, const Affine& place) {
  const auto scale = similarity_of(place);
  if (!scale) return std::nullopt;
  return RigidPart{RigidSphere{sphere.radius * *scale}, frame_at(place.point(sphere.center))};
}

// Unless it is skewed.
MaybePart part(const Box& box, const Affine& place) {
  const Vec3d lengths{length(place.x), length(place.y), length(place.z)};
  const Vec3d x = place.x * (1 / lengths.x), y = place.y * (1 / lengths.y);
  const Vec3d z = place.z * (1 / lengths.z);
  constexpr double square = 1e-9;
  if (std::max({std::abs(dot(x, y)), std::abs(dot(y, z)), std::abs(dot(z, x))}) > square)
    return std::nullopt;
  return RigidPart{
      RigidBox{(box.max - box.min) * lengths * 0.5},
      {x, y, dot(cross(x, y), z) < 0 ? -z : z, place.point((box.min + box.max) * 0.5)}};
}

MaybePart part(const Cylinder& c, const Affine& place) {
  const auto scale = similarity_of(place);
  if (!scale) return std::nullopt;
  const Vec3d base = place.point(c.base), cap = place.point(c.cap);
  return RigidPart{RigidCylinder{c.radius * *scale, length(cap - base) / 2},
                   frame_along(cap - base, (base + cap) * 0.5)};
}

// With a tip.
MaybePart part(const Cone& c, const Affine& place) {
  const auto scale = similarity_of(place);
  if (!scale || (c.base_radius > 0 && c.cap_radius > 0)) return std::nullopt;
  Vec3d base = place.point(c.base), tip = place.point(c.cap);
  if (c.base_radius == 0) std::swap(base, tip);
  return RigidPart{
      RigidCone{std::max(c.base_radius, c.cap_radius) * *scale, length(tip - base) / 2},
      frame_along(tip - base, (base + tip) * 0.5)};
}

MaybePart part(const Capsule& c, const Affine& place) {
  const auto scale = similarity_of(place);
  if (!scale) return std::nullopt;
  const Vec3d base = place.point(c.base), cap = place.point(c.cap);
  const Vec3d middle = (base + cap) * 0.5;
  if (base == cap) return RigidPart{RigidSphere{c.radius * *scale}, frame_at(middle)};
  return RigidPart{RigidCapsule{c.radius * *scale, length(cap - base) / 2},
                   frame_along(cap - base, middle)};
}

template <class Other>
MaybePart part(const Other&, const Affine&) {
  return std::nullopt;
}

// ---- their inertia, of a mass, and radius around the centre of mass ---------------------------

MovingPart moving(const RigidSphere& s, const Affine& at, double mass) {
  return {{s, at}, {at, sphere_moments(mass, s.radius)}, s.radius};
}
MovingPart moving(const RigidBox& box, const Affine& at, double mass) {
  return {{box, at}, {at, box_moments(mass, box.half)}, length(box.half)};
}
MovingPart moving(const RigidCylinder& c, const Affine& at, double mass) {
  return {{c, at},
          {at, cylinder_moments(mass, c.radius, 2 * c.half_height)},
          std::sqrt(c.radius * c.radius + c.half_height * c.half_height)};
}
MovingPart moving(const RigidCone& c, const Affine& at, double mass) {
  Affine center = at;  // a quarter of the height above the base
  center.offset = at.offset - at.y * (c.half_height / 2);
  const double below = c.half_height / 2;
  return {{c, at},
          {center, cone_moments(mass, c.radius, 2 * c.half_height)},
          std::max(3 * below, std::sqrt(c.radius * c.radius + below * below))};
}
MovingPart moving(const RigidCapsule& c, const Affine& at, double mass) {
  return {
      {c, at}, {at, capsule_moments(mass, c.radius, 2 * c.half_height)}, c.radius + c.half_height};
}
template <class Other>
MovingPart moving(const Other& shape, const Affine& at, double) {
  return {{shape, at}, {}, 0};  // no other is made of an object that moves
}

// ---- triangles ----------------------------------------------------------------------------------

Surface surface_of(const Mesh& mesh, const Affine& place) {
  Surface surface;
  const auto& p = mesh.positions.values.get();
  for (std::size_t i = 0; i + 2 < p.size(); i += 3)
    surface.points.push_back(place.point(Vec3d{p[i], p[i + 1], p[i + 2]}));
  const auto& n = mesh.indices.values.get();
  for (std::size_t i = 0; i + 2 < n.size(); i += 3)
    surface.triangles.push_back({n[i], n[i + 1], n[i + 2]});
  return surface;
}

Surface surface_of(const Triangle& t, const Affine& place) {
  return {{place.point(t.a), place.point(t.b), place.point(t.c)}, {{{0, 1, 2}}}};
}

// Corner k is at max where bit i of k is set, along axis i.
Surface surface_of(const Box& box, const Affine& place) {
  Surface surface;
  for (unsigned k = 0; k < 8; ++k)
    surface.points.push_back(place.point(Vec3d{(k & 1U) != 0 ? box.max.x : box.min.x,
                                               (k & 2U) != 0 ? box.max.y : box.min.y,
                                               (k & 4U) != 0 ? box.max.z : box.min.z}));
  surface.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                       {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return surface;
}

// A frustum of so many sides.
Surface surface_of(const Cone& cone, const Affine& place) {
  constexpr std::uint32_t sides = 64;
  Surface surface;
  const Affine frame = frame_along(cone.cap - cone.base, {});
  for (std::uint32_t k = 0; k < sides; ++k) {
    const double turn = 2 * pi * k / sides;
    const Vec3d out = frame.x * cos_of(turn) + frame.z * sin_of(turn);
    surface.points.push_back(place.point(cone.base + out * cone.base_radius));
    surface.points.push_back(place.point(cone.cap + out * cone.cap_radius));
    const std::uint32_t a = 2 * k, b = 2 * ((k + 1) % sides);
    surface.triangles.insert(surface.triangles.end(), {{a, a + 1, b + 1}, {a, b + 1, b}});
    if (k > 0 && k + 1 < sides)
      surface.triangles.insert(surface.triangles.end(), {{0, a, b}, {1, b + 1, a + 1}});
  }
  return surface;
}

template <class Other>
Surface surface_of(const Other&, const Affine&) {
  return {};
}

MovingPart moving_hull(Surface surface, double mass) {
  const Inertia inertia = mesh_inertia(mass, surface.points, surface.triangles);
  const Affine inner = inertia.frame.inverse();
  double radius = 0;
  for (Vec3d& p : surface.points) {
    p = inner.point(p);
    radius = std::max(radius, length(p));
  }
  return {{RigidHull{std::move(surface.points)}, inertia.frame}, inertia, radius};
}

}  // namespace

bool add_fixed_parts(const Object& object, const Affine& parent, std::vector<RigidPart>& into) {
  const Affine place = parent * object.transform.affine();
  const auto* group = std::get_if<Group>(&object.shape);
  if (group != nullptr || std::holds_alternative<Walls>(object.shape)) {
    if (group != nullptr && group->repeat) return false;
    return std::ranges::all_of(*children_of(object), [&](const Object& child) {
      return add_fixed_parts(child, place, into);
    });
  }
  if (const auto* plane = std::get_if<Plane>(&object.shape)) {
    const Vec3d normal = normalize(place.inverse().row(plane->normal));
    into.push_back({RigidPlane{normal}, frame_at(place.point(plane->point))});
    return true;
  }
  if (auto known = std::visit([&](const auto& s) { return part(s, place); }, object.shape)) {
    into.push_back(std::move(*known));
    return true;
  }
  Surface surface = std::visit([&](const auto& s) { return surface_of(s, place); }, object.shape);
  if (surface.triangles.empty()) return false;
  into.push_back({RigidMesh{std::move(surface.points), std::move(surface.triangles)}, {}});
  return true;
}

std::optional<MovingPart> moving_part(const Shape& shape, const Affine& place, double mass) {
  if (const auto known = std::visit([&](const auto& s) { return part(s, place); }, shape))
    return std::visit([&](const auto& s) { return moving(s, known->frame, mass); }, known->shape);
  if (!measure_of(shape)) return std::nullopt;
  Surface surface = std::visit([&](const auto& s) { return surface_of(s, place); }, shape);
  if (surface.triangles.empty()) return std::nullopt;
  return moving_hull(std::move(surface), mass);
}

}  // namespace tia
