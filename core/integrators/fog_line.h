// FogLine: distances along a ray through fog, drawn where it scatters light.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/math/deterministic.h"
#include "core/math/powers.h"
#include "core/math/vec3.h"

namespace tia {

/// FogLine: the part of a ray that lies in homogeneous fog, from the distance `near` to `far`,
/// which may be infinite. Domain: a unit direction; 0 <= near < far; density > 0.
struct FogLine {
  Vec3d origin, direction;
  double near, far, density;
  bool open = false;  ///< whether nothing lies behind it, and each path is scattered in it

  Vec3d point(double t) const { return origin + direction * t; }
  /// The share of light that does not come through.
  double taken() const { return share_of(density * (far - near)); }

  /// Where the fog meets light that does not come through.
  double within(double u) const { return held(near + depth_of(u * taken()) / density); }
  double within_pdf(double t) const { return met(t) / taken(); }
  /// How far a path goes before the fog scatters it: beyond `far` where it comes through, which an
  /// open line lets none.
  double flight(double u) const { return open ? within(u) : near + depth_of(u) / density; }
  double flight_pdf(double t) const { return open ? within_pdf(t) : met(t); }
  /// What a path counts that is scattered so.
  double flight_weight() const { return open ? taken() : 1; }

  /// Evenly by the angle seen from a point, so that the square of the distance from it falls out.
  /// Source: Kulla, Fajardo, "Importance sampling techniques for path tracing in participating
  /// media", Computer Graphics Forum 31(4) (2012).
  double equiangular(const Vec3d& from, double u) const {
    const Angles at = angles(from);
    if (at.narrow()) return within(u);
    return held(at.foot + at.away * tan_of(at.first + u * (at.last - at.first)));
  }
  double equiangular_pdf(const Vec3d& from, double t) const {
    const Angles at = angles(from);
    if (at.narrow()) return within_pdf(t);
    const double aside = t - at.foot;
    return at.away / ((at.last - at.first) * (at.away * at.away + aside * aside));
  }

 private:
  double met(double t) const { return density * exp_of(-density * (t - near)); }
  struct Angles {
    double foot, away;   // where the ray is nearest to the point, and how near
    double first, last;  // the angles of near and far, from there
    // Whether so little is seen that the difference is made of roundings.
    bool narrow() const { return last - first < 1e-9; }
  };
  Angles angles(const Vec3d& from) const {
    const double foot = dot(from - origin, direction);
    const Vec3d aside = from - point(foot);
    // A ray through the point itself is treated as one that passes it closely.
    const double away = std::max(length(aside), 1e-4 * length(from - origin) + 1e-30);
    return {foot, away, atan2_of(near - foot, away), atan2_of(far - foot, away)};
  }
  double held(double t) const { return std::clamp(t, near, far); }
  // 1 - e^-x and -log(1 - x), also where x is far below 1.
  static double share_of(double x) {
    return x < 1e-4 ? x * (1 - x / 2 * (1 - x / 3)) : 1 - exp_of(-x);
  }
  static double depth_of(double x) {
    return x < 1e-4 ? x * (1 + x * (1.0 / 2 + x / 3)) : -log_of(1 - x);
  }
};

}  // namespace tia
