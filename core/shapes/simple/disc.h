// The disc: the part of a plane within a radius. It has no inside.
#pragma once

#include <algorithm>
#include <string_view>

#include "core/input/errors.h"
#include "core/input/fields.h"
#include "core/math/onb.h"
#include "core/shapes/crossing.h"

namespace tia {

/// Disc. Surface: (p - center) . normal = 0 and |p - center| <= radius.
/// Space/units: scene units, object space; the normal's length is of no account.
struct Disc {
  static constexpr std::string_view type = "disc";
  Vec3d center{};
  Vec3d normal{0, 1, 0};
  double radius = 0;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("center", &Disc::center,
          Spec{.about = "the centre", .min = -1e9, .max = 1e9, .required = true});
    visit("normal", &Disc::normal,
          Spec{.about = "what the disc is perpendicular to",
               .min = -1e9,
               .max = 1e9,
               .required = true});
    visit("radius", &Disc::radius,
          Spec{.about = "the radius", .min = 0, .max = 1e9, .open_min = true, .required = true});
  }
  void check(const Place& at, Faults& faults) const;
  bool operator==(const Disc&) const = default;
};

struct DiscForm {
  static constexpr bool solid = false;
  Vec3d center{};
  Onb frame{};
  double radius = 0;
};

/// Half the box around a circle of radius 1, perpendicular to the unit vector n.
inline Vec3d circle_reach(const Vec3d& n) {
  return {std::sqrt(n.y * n.y + n.z * n.z), std::sqrt(n.x * n.x + n.z * n.z),
          std::sqrt(n.x * n.x + n.y * n.y)};
}

inline DiscForm prepare(const Disc& disc) {
  return {disc.center, onb_around(unit(disc.normal)), disc.radius};
}
inline int elements(const DiscForm&) { return 1; }
inline Aabb bounds(const DiscForm& disc) {
  const Vec3d reach = circle_reach(disc.frame.n) * disc.radius;
  return {disc.center - reach, disc.center + reach};
}

/// A line in the disc's plane misses it.
template <class Emit>
void crossings(const DiscForm& disc, const Line& line, Emit&& emit) {
  const Vec3d from = line.origin - disc.center;
  const double t = -dot(disc.frame.n, from) / dot(disc.frame.n, line.direction);
  const Vec3d q = from + line.direction * t;
  if (dot(q, q) <= disc.radius * disc.radius) emit(t, 0);
}

inline Vec3d normal(const DiscForm& disc, const Vec3d&, int) { return disc.frame.n; }
/// Returns: the place in the square around the disc, in [0,1]^2.
inline Vec2d uv(const DiscForm& disc, const Vec3d& p, int) {
  const Vec3d local = disc.frame.local(p - disc.center);
  return {std::clamp(local.x / disc.radius / 2 + 0.5, 0.0, 1.0),
          std::clamp(local.y / disc.radius / 2 + 0.5, 0.0, 1.0)};
}

static_assert(IsForm<DiscForm>);

}  // namespace tia
