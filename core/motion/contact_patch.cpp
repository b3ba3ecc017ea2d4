#include "core/motion/contact_patch.h"

#include <cmath>

#include "core/math/onb.h"

namespace tia {
namespace {

// The way from the nearest point of a patch's middle: of an axis, a centre.
Vec3d way_from_middle(const CylinderPatch& patch, const Vec3d& x) {
  const Vec3d d = x - patch.base;
  return d - patch.axis * dot(patch.axis, d);
}
Vec3d way_from_middle(const SpherePatch& patch, const Vec3d& x) { return x - patch.center; }

bool is_over(const PlanePatch& patch, const Vec3d& x, double margin) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(patch.sides); ++i)
    if (dot(patch.inward[i], x) - patch.offset[i] < -margin) return false;
  if (patch.disc_radius == 0) return true;
  const Vec3d d = x - patch.point, aside = d - patch.normal * dot(patch.normal, d);
  const double most = patch.disc_radius + margin;
  return dot(aside, aside) <= most * most;
}
bool is_over(const CylinderPatch& patch, const Vec3d& x, double margin) {
  const double z = dot(patch.axis, x - patch.base);
  return -margin <= z && z <= patch.length + margin;
}
bool is_over(const SpherePatch& patch, const Vec3d& x, double margin) {
  return dot(patch.half, x - patch.center) >= -margin;
}
bool is_over(const CirclePatch&, const Vec3d&, double) { return true; }

Touch whole_touch(const PlanePatch& patch, const Vec3d& x, double radius) {
  const double height = dot(patch.normal, x - patch.point);
  return {std::fabs(height) - radius, height < 0 ? -patch.normal : patch.normal};
}
// A ball is inside where its centre is.
template <class Round>
Touch whole_touch(const Round& patch, const Vec3d& x, double radius) {
  const Vec3d way = way_from_middle(patch, x);
  const double distance = length(way);
  if (distance < patch.radius)
    return {patch.radius - distance - radius,
            distance > 0 ? way * (-1 / distance) : onb_around(Vec3d{0, 1, 0}).u};
  return {distance - patch.radius - radius,
          distance > 0 ? way * (1 / distance) : onb_around(Vec3d{0, 1, 0}).u};
}
Touch whole_touch(const CirclePatch& patch, const Vec3d& x, double radius) {
  const Vec3d d = x - patch.center, aside = d - patch.axis * dot(patch.axis, d);
  const double far = length(aside);
  const Vec3d outward = far > 0 ? aside * (1 / far) : onb_around(patch.axis).u;
  const Vec3d way = d - outward * patch.radius;
  const double distance = length(way);
  return {distance - radius, distance > 0 ? way * (1 / distance) : patch.axis};
}

// Of a sphere or a cylinder: the part of v across both the normal and the axis, over the radius.
template <class Round>
double round_bend(const Round& patch, const Vec3d& x, const Vec3d& v) {
  const Vec3d way = way_from_middle(patch, x);
  const double square = dot(way, way), along = dot(way, v);
  const double bend = (dot(v, v) - along * along / square) / std::sqrt(square);
  return square < patch.radius * patch.radius ? -bend : bend;
}

double bend(const PlanePatch&, const Vec3d&, const Vec3d&) { return 0; }
double bend(const SpherePatch& patch, const Vec3d& x, const Vec3d& v) {
  return round_bend(patch, x, v);
}
double bend(const CylinderPatch& patch, const Vec3d& x, const Vec3d& v) {
  return round_bend(patch, x, v - patch.axis * dot(patch.axis, v));
}
// A torus: across the circle the ball's radius, along it the distance from the axis by the share of
// the normal that shows away from it.
double bend(const CirclePatch& patch, const Vec3d& x, const Vec3d& v) {
  const Vec3d d = x - patch.center, aside = d - patch.axis * dot(patch.axis, d);
  const double far = length(aside);
  if (far == 0) return 0;
  const Vec3d outward = aside * (1 / far), around = cross(patch.axis, outward);
  const Vec3d way = d - outward * patch.radius;
  const double distance = length(way), turning = dot(around, v);
  const Vec3d n = way * (1 / distance), across = v - around * turning - n * dot(n, v);
  return dot(across, across) / distance + turning * turning * dot(n, outward) / far;
}

}  // namespace

Touch touch_of(const ContactPatch& patch, const Vec3d& x, double radius, double margin) {
  return std::visit(
      [&](const auto& kind) {
        return is_over(kind, x, margin) ? whole_touch(kind, x, radius) : Touch{};
      },
      patch);
}

bool lies_below(const ContactPatch& patch, const PlanePatch& plane, const Vec3d& normal,
                double margin) {
  const auto below = [&](const Vec3d& p) { return dot(normal, p - plane.point) <= margin; };
  if (const auto* edge = std::get_if<CylinderPatch>(&patch))
    return edge->radius == 0 && below(edge->base) && below(edge->base + edge->axis * edge->length);
  const auto* corner = std::get_if<SpherePatch>(&patch);
  return corner != nullptr && corner->radius == 0 && below(corner->center);
}

double bend_of(const ContactPatch& patch, const Vec3d& x, const Vec3d& v) {
  return std::visit([&](const auto& kind) { return bend(kind, x, v); }, patch);
}

double bend_radius(const ContactPatch& patch, const Vec3d& x, double radius) {
  if (std::holds_alternative<PlanePatch>(patch)) return Aabb::far;
  if (const auto* side = std::get_if<CylinderPatch>(&patch))
    return length(way_from_middle(*side, x));
  if (const auto* ball = std::get_if<SpherePatch>(&patch)) return length(way_from_middle(*ball, x));
  return radius;
}

Aabb bounds_of(const ContactPatch& patch) {
  const auto reach = [](double r) { return Vec3d{r, r, r}; };
  if (const auto* flat = std::get_if<PlanePatch>(&patch)) return flat->box;
  if (const auto* side = std::get_if<CylinderPatch>(&patch)) {
    const Vec3d cap = side->base + side->axis * side->length, r = reach(side->radius);
    return {lower(side->base, cap) - r, upper(side->base, cap) + r};
  }
  if (const auto* ball = std::get_if<SpherePatch>(&patch))
    return {ball->center - reach(ball->radius), ball->center + reach(ball->radius)};
  const auto& circle = std::get<CirclePatch>(patch);
  return {circle.center - reach(circle.radius), circle.center + reach(circle.radius)};
}

}  // namespace tia
