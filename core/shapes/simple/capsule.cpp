#include "core/shapes/simple/capsule.h"

#include <algorithm>

#include "core/math/roots.h"
#include "core/shapes/simple/sphere.h"

namespace tia {
namespace {

// The stretch between all points of a line that are found to be on something convex.
void hold(const Crossing& point, Chord& chord) {
  if (point.t < chord.in.t) chord.in = point;
  if (point.t > chord.out.t) chord.out = point;
}

// Where the line meets the side, between the ends of the segment. The terms of the quadratic are
// taken around the line's point nearest to the axis as far as that is between the ends: there they
// are small, however long the capsule.
void hold_side(const CapsuleForm& capsule, const Line& line, Chord& chord) {
  const Vec3d o = capsule.frame.local(line.origin - capsule.middle());
  const Vec3d d = capsule.frame.local(line.direction);
  const double h = capsule.half_height, a = d.x * d.x + d.y * d.y;
  if (!(a > 0)) return;
  double start = -(o.x * d.x + o.y * d.y) / a;
  if (d.z != 0) {
    const double to_base = (-h - o.z) / d.z, to_cap = (h - o.z) / d.z;
    start = std::clamp(start, std::min(to_base, to_cap), std::max(to_base, to_cap));
  }
  const Vec3d q = o + d * start;
  const double b = q.x * d.x + q.y * d.y, c = q.x * q.x + q.y * q.y;
  const QuadraticRoots roots = quadratic_roots(a, b, c - capsule.radius * capsule.radius);
  if (roots.count < 2) return;
  for (const double t : {roots.t0, roots.t1})
    if (std::fabs(q.z + d.z * t) <= h) hold({start + t, CapsuleForm::side}, chord);
}

void hold_ball(const Vec3d& center, double radius, int element, const Line& line, Chord& chord) {
  crossings(Sphere{center, radius}, line, [&](double t, int) { hold({t, element}, chord); });
}

}  // namespace

CapsuleForm prepare(const Capsule& c) {
  const bool is_ball = c.cap == c.base;
  const Vec3d n = is_ball ? Vec3d{0, 1, 0} : unit(c.cap - c.base);
  return {c.base, c.cap, c.radius, onb_around(n), dot(c.cap - c.base, n) / 2};
}

Aabb bounds(const CapsuleForm& c) {
  const Vec3d reach{c.radius, c.radius, c.radius};
  return {lower(c.base, c.cap) - reach, upper(c.base, c.cap) + reach};
}

// It is convex, and its chord ends where the first and the last of its pieces' surfaces are met:
// what of a ball lies inside the side is neither.
Chord chord(const CapsuleForm& capsule, const Line& line) {
  Chord held;
  hold_side(capsule, line, held);
  hold_ball(capsule.base, capsule.radius, CapsuleForm::base_ball, line, held);
  hold_ball(capsule.cap, capsule.radius, CapsuleForm::cap_ball, line, held);
  return held;
}

Vec3d normal(const CapsuleForm& capsule, const Vec3d& p, int element) {
  if (element == CapsuleForm::base_ball) return unit(p - capsule.base);
  if (element == CapsuleForm::cap_ball) return unit(p - capsule.cap);
  const Vec3d w = p - capsule.middle();
  return unit(w - capsule.frame.n * dot(capsule.frame.n, w));
}

Vec2d uv(const CapsuleForm& capsule, const Vec3d& p, int element) {
  const Vec3d local = capsule.frame.local(p - capsule.middle());
  const double r = capsule.radius, h = capsule.half_height;
  const double aside = std::sqrt(local.x * local.x + local.y * local.y);
  const double whole = pi * r + 2 * h;
  double way = pi / 2 * r + h + local.z;
  if (element == CapsuleForm::base_ball) way = r * atan2_of(aside, -(local.z + h));
  if (element == CapsuleForm::cap_ball) way = whole - r * atan2_of(aside, local.z - h);
  return {turn_of(local.y, local.x), std::clamp(way / whole, 0.0, 1.0)};
}

}  // namespace tia
