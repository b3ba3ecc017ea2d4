#include "core/shapes/simple/cone.h"

#include <algorithm>

#include "core/input/codec.h"
#include "core/math/roots.h"
#include "core/shapes/simple/disc.h"

namespace tia {
namespace {

// |cap - base| against the radius: flatter than this, the ends would merge within rounding.
constexpr double flattest = 1e-9;

void check_axis(const Vec3d& base, const Vec3d& cap, double radius, const Place& at,
                Faults& faults) {
  if (cap == base || !(length(cap - base) >= flattest * radius))
    faults.add({FaultKind::out_of_range, at.at("cap").pointer(), write_value(cap),
                "a point other than base, at least 1e-9 of the radius away"});
}

// The side as a quadratic in t: a t^2 + 2 b t + c < 0 inside the double cone that it is part of.
struct Side {
  double a, b, c;
  // Around the line's point o, both in the frustum's frame.
  Side(const Frustum& f, const Vec3d& o, const Vec3d& d) {
    const double square = f.cosine * f.cosine;
    const double reach = f.cosine * ((f.base_radius + f.cap_radius) / 2) + f.sine * o.z;
    const double growth = f.sine * d.z;
    a = square * (d.x * d.x + d.y * d.y) - growth * growth;
    b = square * (o.x * d.x + o.y * d.y) - reach * growth;
    c = square * (o.x * o.x + o.y * o.y) - reach * reach;
  }
};

// Where the side's quadratic is least between the ends, or the middle between them if it has no
// least. From there its terms are small beside the frustum, however long that is.
double stage(const Side& side, const Chord& slab) {
  if (!(side.a > 0)) return (slab.in.t + slab.out.t) / 2;
  return std::clamp(-side.b / side.a, slab.in.t, slab.out.t);
}

void enter_at(double t, Chord& chord) {
  if (t > chord.in.t) chord.in = {t, Frustum::side};
}
void leave_at(double t, Chord& chord) {
  if (t < chord.out.t) chord.out = {t, Frustum::side};
}

// What the side leaves of a chord between the ends, t counted from `start`.
Chord within_side(const Side& side, bool widens, double start, Chord chord) {
  QuadraticRoots roots = quadratic_roots(side.a, side.b, side.c);
  if (side.a > 0) {
    if (roots.count == 0) return {};
    enter_at(start + roots.t0, chord);
    leave_at(start + roots.t1, chord);
  } else if (side.a < 0) {
    // Steeper than the side: it meets both halves of the double cone, the tip if nothing else.
    if (roots.count == 0) roots.t0 = roots.t1 = -side.b / side.a;
    if (widens) enter_at(start + roots.t1, chord);
    else leave_at(start + roots.t0, chord);
  } else if (roots.count == 1) {
    if (side.b < 0) enter_at(start + roots.t0, chord);
    else leave_at(start + roots.t0, chord);
  } else if (side.c > 0) {
    return {};
  }
  return chord;
}

}  // namespace

void Cylinder::check(const Place& at, Faults& faults) const {
  check_axis(base, cap, radius, at, faults);
}

void Cone::check(const Place& at, Faults& faults) const {
  check_axis(base, cap, std::max(base_radius, cap_radius), at, faults);
  if (base_radius == 0 && cap_radius == 0)
    faults.add({FaultKind::out_of_range, at.at("cap_radius").pointer(), cap_radius,
                "above 0 where base_radius is 0"});
}

Frustum prepare(const Cone& cone) {
  const Vec3d axis = cone.cap - cone.base;
  const Vec3d n = unit(axis);
  const double height = dot(axis, n);
  const double growth = cone.cap_radius - cone.base_radius;
  const Vec3d slope = unit({height, growth, 0});
  return {(cone.base + cone.cap) * 0.5,
          onb_around(n),
          height / 2,
          cone.base_radius,
          cone.cap_radius,
          slope.x,
          slope.y};
}

Aabb bounds(const Frustum& f) {
  const Vec3d reach = circle_reach(f.frame.n), up = f.frame.n * f.half_height;
  const Vec3d base = f.middle - up, cap = f.middle + up;
  return around(Aabb{base - reach * f.base_radius, base + reach * f.base_radius},
                Aabb{cap - reach * f.cap_radius, cap + reach * f.cap_radius});
}

Chord chord(const Frustum& f, const Line& line) {
  const Vec3d o = f.frame.local(line.origin - f.middle), d = f.frame.local(line.direction);
  if (!std::isfinite(o.x + o.y + o.z + d.x + d.y + d.z)) return {};
  const double h = f.half_height;
  Chord slab = Chord::everything();
  if (d.z > 0) slab = {{(-h - o.z) / d.z, Frustum::base}, {(h - o.z) / d.z, Frustum::cap}};
  else if (d.z < 0) slab = {{(h - o.z) / d.z, Frustum::cap}, {(-h - o.z) / d.z, Frustum::base}};
  else if (!(-h <= o.z && o.z < h)) return {};

  const double start = stage(Side(f, o, d), slab);
  return within_side(Side(f, o + d * start, d), f.sine * d.z > 0, start, slab);
}

Vec3d normal(const Frustum& f, const Vec3d& p, int element) {
  const Vec3d& n = f.frame.n;
  if (element == Frustum::base) return -n;
  if (element == Frustum::cap) return n;
  const Vec3d w = p - f.middle;
  const Vec3d aside = w - n * dot(n, w);
  const double distance = length(aside);
  if (distance == 0) return f.sine > 0 ? -n : n;
  return aside * (f.cosine / distance) - n * f.sine;
}

Vec2d uv(const Frustum& f, const Vec3d& p, int element) {
  const auto share = [](double from_middle) { return std::clamp(from_middle + 0.5, 0.0, 1.0); };
  const Vec3d local = f.frame.local(p - f.middle);
  if (element == Frustum::side)
    return {turn_of(local.y, local.x), share(local.z / f.half_height / 2)};
  const double radius = element == Frustum::base ? f.base_radius : f.cap_radius;
  return radius > 0 ? Vec2d{share(local.x / radius / 2), share(local.y / radius / 2)} : Vec2d{};
}

}  // namespace tia
