// The plane; as a solid, the half space behind its normal.
#pragma once

#include <string_view>

#include "core/input/errors.h"
#include "core/input/fields.h"
#include "core/math/onb.h"
#include "core/math/ray.h"
#include "core/shapes/crossing.h"

namespace tia {

/// Plane. Surface: (p - point) . normal = 0, infinite; inside where that is below 0.
/// Space/units: scene units, object space; the normal's length is of no account.
struct Plane {
  static constexpr std::string_view type = "plane";
  Vec3d point{};
  Vec3d normal{0, 1, 0};

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("point", &Plane::point,
          Spec{.about = "a point of the plane", .min = -1e9, .max = 1e9, .required = true});
    visit("normal", &Plane::normal,
          Spec{.about = "what the plane is perpendicular to; the solid lies behind it",
               .min = -1e9,
               .max = 1e9,
               .required = true});
  }
  void check(const Place& at, Faults& faults) const;
  bool operator==(const Plane&) const = default;
};

struct PlaneForm {
  static constexpr bool solid = true;
  Vec3d point{};
  Onb frame{};
};

inline PlaneForm prepare(const Plane& plane) {
  return {plane.point, onb_around(unit(plane.normal))};
}

/// Returns: the positive t where the ray meets the plane, else infinite.
template <class Real>
[[gnu::always_inline]] inline Real intersect(const PlaneForm& plane, const RootRay<Real>& ray) {
  using P = Precise<Real>;
  const Vec3<P> n = static_cast<Vec3<P>>(plane.frame.n);
  const P height = dot(n, static_cast<Vec3<P>>(plane.point) - ray.origin);
  const Real t = narrow<Real>(height / dot(n, ray.direction));
  return select(t > Real(0), t, Real(infinity));
}

inline int elements(const PlaneForm&) { return 1; }
inline Aabb bounds(const PlaneForm&) { return Aabb::everything(); }

/// A line in the plane itself runs outside.
template <class Emit>
void crossings(const PlaneForm& plane, const Line& line, Emit&& emit) {
  const double rate = dot(plane.frame.n, line.direction);
  const double height = dot(plane.frame.n, line.origin - plane.point);
  const double t = -height / rate;
  const bool meets = std::isfinite(t);  // else parallel, or as good as that
  if (std::isnan(rate) || !(meets || height < 0)) return;
  emit(meets && rate < 0 ? t : -Aabb::far, 0);
  emit(meets && rate > 0 ? t : Aabb::far, 0);
}

inline Vec3d normal(const PlaneForm& plane, const Vec3d&, int) { return plane.frame.n; }
/// Returns: scene units along two perpendicular directions of the plane, 0 at its point.
inline Vec2d uv(const PlaneForm& plane, const Vec3d& p, int) {
  const Vec3d local = plane.frame.local(p - plane.point);
  return {local.x, local.y};
}

static_assert(IsForm<PlaneForm>);

}  // namespace tia
