#include "core/motion/contact_time.h"

#include <algorithm>
#include <cmath>

#include "core/motion/falls.h"

namespace tia {
namespace {

constexpr double never = Aabb::far;
using Quartic = std::array<double, 5>;

// |x(t)|^2.
Quartic square_of(const Flight& f) {
  const Vec3d &x = f.position, &v = f.velocity, &a = f.acceleration;
  return {dot(x, x), 2 * dot(x, v), dot(v, v) + dot(x, a), dot(v, a), dot(a, a) / 4};
}
// n . x(t) - offset.
std::array<double, 3> height_of(const Vec3d& n, double offset, const Flight& f) {
  return {dot(n, f.position) - offset, dot(n, f.velocity), dot(n, f.acceleration) / 2};
}
Flight from_point(const Flight& f, const Vec3d& p) {
  return {f.position - p, f.velocity, f.acceleration};
}
// What of the flight is across an axis.
Flight across(const Flight& f, const Vec3d& axis) {
  const auto part = [&](const Vec3d& v) { return v - axis * dot(axis, v); };
  return {part(f.position), part(f.velocity), part(f.acceleration)};
}

struct Gap {
  double size, rate;
};
// The roots of polynomials of far positions have lost digits; Newton's steps on the gap itself give
// them back, as long as they make it smaller.
template <class GapAt>
double polished(double t, const GapAt& gap_at) {
  Gap gap = gap_at(t);
  for (int i = 0; i < 4 && gap.rate < 0 && gap.size != 0; ++i) {
    const double next = t - gap.size / gap.rate;
    if (!(next >= 0) || next == t) break;
    const Gap there = gap_at(next);
    if (!(std::fabs(there.size) < std::fabs(gap.size))) break;
    t = next;
    gap = there;
  }
  return t;
}

double first_fall(std::span<const double> polynomial, double until) {
  const Falls falls = falls_of(polynomial, until, GapStart::apart);
  return falls.count > 0 ? falls.times[0] : never;
}

// Calls visit(p) for each straight bound of a patch, where p, of a centre on the flight, is above 0
// inside of it.
template <class Visit>
void for_each_bound(const ContactPatch& patch, const Flight& f, Visit visit) {
  if (const auto* plane = std::get_if<PlanePatch>(&patch)) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(plane->sides); ++i)
      visit(height_of(plane->inward[i], plane->offset[i], f));
  } else if (const auto* side = std::get_if<CylinderPatch>(&patch)) {
    const double base = dot(side->axis, side->base);
    visit(height_of(side->axis, base, f));
    visit(height_of(-side->axis, -base - side->length, f));
  } else if (const auto* ball = std::get_if<SpherePatch>(&patch); ball && ball->half != Vec3d{}) {
    visit(height_of(ball->half, dot(ball->half, ball->center), f));
  }
}

// Sides from which a patch can be met: of planes by the sign of their normals, of what is round
// from outside or from inside.
enum class Side { positive, negative };

// Search for the first fall of a side's polynomial that is on the patch and on that side.
class Search {
 public:
  Search(const ContactPatch& patch, const Flight& flight, double radius, double until,
         const GapTolerance& tolerance)
      : patch_(patch), flight_(flight), radius_(radius), until_(until), tolerance_(tolerance) {}

  double first() {
    const Touch now = touch_of(patch_, flight_.position, radius_, margin());
    if (now.gap <= tolerance_.touch && now.gap >= -deepest()) {
      const bool approaches = dot(now.normal, flight_.velocity) < -tolerance_.approach;
      if (approaches && !is_thin()) return 0;
      if (!approaches) start_ = GapStart::touching;
    }
    std::visit([&](const auto& kind) { try_sides(kind); }, patch_);
    try_entries();
    return first_;
  }

 private:
  // Edges and corners, which a ball may pass on its way over a face, nearer than rounding tells.
  bool is_thin() const {
    const auto* edge = std::get_if<CylinderPatch>(&patch_);
    const auto* corner = std::get_if<SpherePatch>(&patch_);
    return (edge != nullptr && edge->radius == 0) || (corner != nullptr && corner->radius == 0);
  }
  double margin() const { return tolerance_.touch / 4; }
  // What overlaps more does not touch from here: it is beside the patch, or on its other side.
  double deepest() const { return 1024 * tolerance_.touch; }

  void try_sides(const PlanePatch& plane) {
    const auto height = height_of(plane.normal, dot(plane.normal, plane.point), flight_);
    const bool above = height[0] >= 0, bounded = plane.sides != 0 || plane.disc_radius != 0;
    if (above || bounded)
      try_falls(std::array{height[0] - radius_, height[1], height[2]}, Side::positive);
    if (!above || bounded)
      try_falls(std::array{-height[0] - radius_, -height[1], -height[2]}, Side::negative);
  }
  void try_sides(const CylinderPatch& side) {
    try_round(square_of(across(from_point(flight_, side.base), side.axis)), side.radius);
  }
  void try_sides(const SpherePatch& ball) {
    try_round(square_of(from_point(flight_, ball.center)), ball.radius);
  }
  void try_round(Quartic square, double round) {
    const double outer = round + radius_, inner = round - radius_;
    Quartic outside = square;
    outside[0] -= outer * outer;
    try_falls(outside, Side::positive);
    if (inner <= 0) return;
    for (double& each : square) each = -each;
    square[0] += inner * inner;
    try_falls(square, Side::negative);
  }
  // (|x|^2 + R^2 - r^2)^2 - 4 R^2 |x across the axis|^2, of eighth degree.
  void try_sides(const CirclePatch& circle) {
    const Flight own = from_point(flight_, circle.center);
    Quartic square = square_of(own);
    const Quartic aside = square_of(across(own, circle.axis));
    square[0] += circle.radius * circle.radius - radius_ * radius_;
    std::array<double, 9> torus{};
    for (std::size_t i = 0; i < 5; ++i)
      for (std::size_t j = 0; j < 5; ++j) torus[i + j] += square[i] * square[j];
    for (std::size_t i = 0; i < 5; ++i) torus[i] -= 4 * circle.radius * circle.radius * aside[i];
    try_falls(torus, Side::positive);
  }

  // Where a ball comes over the patch from beside it as it leaves its neighbour, it may be in it by
  // rounding already, and the fall before.
  void try_entries() {
    if (is_thin()) return;
    for_each_bound(patch_, flight_, [&](std::array<double, 3> inside) {
      for (double& each : inside) each = -each;
      const double t = first_fall(inside, std::min(until_, first_));
      if (!(t < first_)) return;
      const Touch touch = touch_of(patch_, flight_.position_at(t), radius_, margin());
      if (touch.gap < -deepest() || touch.gap > 0) return;
      if (dot(touch.normal, flight_.velocity_at(t)) < -tolerance_.approach) first_ = t;
    });
  }
  void try_falls(std::span<const double> polynomial, Side side) {
    for (const double fall : falls_of(polynomial, std::min(until_, first_), start_)) {
      const double t = polished(fall, [&](double at) {
        const Touch touch = touch_of(patch_, flight_.position_at(at), radius_, never);
        return Gap{touch.gap, dot(touch.normal, flight_.velocity_at(at))};
      });
      if (!(t < first_ && t <= until_)) continue;
      const Vec3d x = flight_.position_at(t);
      const Touch touch = touch_of(patch_, x, radius_, margin());
      if (std::fabs(touch.gap) <= deepest() && side_of(x) == side) first_ = t;
    }
  }
  Side side_of(const Vec3d& x) const {
    if (const auto* plane = std::get_if<PlanePatch>(&patch_))
      return dot(plane->normal, x - plane->point) >= 0 ? Side::positive : Side::negative;
    const auto* side = std::get_if<CylinderPatch>(&patch_);
    const auto* ball = std::get_if<SpherePatch>(&patch_);
    if (side == nullptr && ball == nullptr) return Side::positive;
    const Vec3d from_base = x - (side != nullptr ? side->base : ball->center);
    const Vec3d way =
        side != nullptr ? from_base - side->axis * dot(side->axis, from_base) : from_base;
    const double round = side != nullptr ? side->radius : ball->radius;
    return dot(way, way) >= round * round ? Side::positive : Side::negative;
  }

  const ContactPatch& patch_;
  const Flight& flight_;
  const double radius_, until_;
  const GapTolerance& tolerance_;
  GapStart start_ = GapStart::apart;
  double first_ = never;
};

}  // namespace

double contact_time(const ContactPatch& patch, const Flight& flight, double radius, double until,
                    const GapTolerance& tolerance) {
  return Search(patch, flight, radius, until, tolerance).first();
}

double pair_time(const Flight& flight, double radii, double until, const GapTolerance& tolerance) {
  Quartic polynomial = square_of(flight);
  const double square = polynomial[0];
  polynomial[0] -= radii * radii;
  const bool straight = flight.acceleration == Vec3d{};
  if (straight && polynomial[1] >= 0) return never;
  GapStart start = GapStart::apart;
  if (polynomial[0] <= 3 * radii * tolerance.touch) {  // else no need for the root
    const double distance = std::sqrt(square);
    if (distance - radii <= tolerance.touch) {
      start = GapStart::touching;
      if (polynomial[1] < -2 * distance * tolerance.approach) return 0;
    }
  }
  const Falls falls = falls_of(std::span(polynomial).first(straight ? 3 : 5), until, start);
  if (falls.count == 0) return never;
  return polished(falls.times[0], [&](double t) {
    const Vec3d d = flight.position_at(t);
    const double distance = length(d);
    return Gap{distance - radii, dot(d, flight.velocity_at(t)) / distance};
  });
}

double end_of_patch(const ContactPatch& patch, const Flight& flight, double until, double touch) {
  double first = never;
  for_each_bound(patch, flight, [&](std::array<double, 3> inside) {
    inside[0] += touch / 2;
    first = std::min(first, first_fall(inside, until));
  });
  const auto* disc = std::get_if<PlanePatch>(&patch);
  if (disc == nullptr || disc->disc_radius == 0) return first;
  Quartic inside = square_of(across(from_point(flight, disc->point), disc->normal));
  for (double& each : inside) each = -each;
  const double most = disc->disc_radius + touch / 2;
  inside[0] += most * most;
  return first_fall(inside, until);
}

}  // namespace tia
