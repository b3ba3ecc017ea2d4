#include "core/lights/spot.h"

#include <algorithm>

#include "core/input/codec.h"
#include "core/input/json.h"
#include "core/math/roots.h"

namespace tia {

void SpotLight::check(const Place& at, Faults& faults) const {
  if (falloff_degrees < radius_degrees)
    faults.add({FaultKind::out_of_range, at.at("falloff_degrees").pointer(), Value(falloff_degrees),
                "a number from radius_degrees, " + number_text(radius_degrees) + ", to 180"});
  if (position == point_at)
    faults.add({FaultKind::out_of_range, at.at("point_at").pointer(), write_value(point_at),
                "a point other than position"});
}

namespace {

// The stretch of the line aside + t direction that a convex cone around the axis holds, its apex at
// the origin; empty: from > to. The square of the cosine is that of both nappes, the quadratic
// positive within them. Domain: aside perpendicular to the direction; cosine > 0.
LitSpans::Span within_cone(const Vec3d& aside, const Vec3d& direction, const Vec3d& axis,
                           double cosine) {
  const LitSpans::Span none{1, -1};
  const double along = dot(direction, axis), up = dot(aside, axis), square = cosine * cosine;
  const double a = along * along - square;
  const double half_b = along * up, c = up * up - square * dot(aside, aside);
  if (a < 0) {  // the line leaves the cone at both ends
    const QuadraticRoots roots = quadratic_roots(a, half_b, c);
    return up > 0 && roots.count == 2 ? LitSpans::Span{roots.t0, roots.t1} : none;
  }
  // It is in one nappe at the one end and in the other at the other end. Beside the cone's surface
  // it meets one of them next to infinitely far.
  const double bent = std::max(a, 1e-300);
  QuadraticRoots roots = quadratic_roots(bent, half_b, c);
  if (roots.count < 2) roots.t0 = roots.t1 = -half_b / bent;  // through the apex
  return along > 0 ? LitSpans::Span{roots.t1, LitSpans::endless}
                   : LitSpans::Span{-LitSpans::endless, roots.t0};
}

}  // namespace

LitSpans lit_spans(const SpotForm& light, const Vec3d& origin, const Vec3d& direction) {
  const Vec3d way = origin - light.position.exact, axis = light.axis.exact;
  const double foot = -dot(way, direction);
  // A power of the cosine leaves half of space dark.
  const double cosine = light.tightness > 0 ? std::max(light.cos_falloff, 0.0) : light.cos_falloff;
  // More than half of space is what the cone around the opposite axis does not hold. A half is
  // taken for a cone, too, which none tells from it.
  const bool is_wide = cosine < 0;
  const auto [from, to] = within_cone(way + direction * foot, direction, is_wide ? -axis : axis,
                                      std::max(std::fabs(cosine), 1e-9));
  LitSpans lit;
  if (!is_wide) {
    lit.add(foot + from, foot + to);
  } else if (from < to) {
    lit.add(-LitSpans::endless, foot + from);
    lit.add(foot + to, LitSpans::endless);
  } else {
    lit = LitSpans::whole();
  }
  return lit;
}

}  // namespace tia
