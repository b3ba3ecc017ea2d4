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
class FogLine {
 public:
  /// `open`: whether nothing lies behind it, and each path is scattered in it.
  FogLine(const Vec3d& origin, const Vec3d& direction, double near, double far, double density,
          bool open = false)
      : origin_(origin),
        direction_(direction),
        near_(near),
        far_(far),
        density_(density),
        taken_(share_of(density * (far - near))),
        open_(open) {}

  Vec3d point(double t) const { return origin_ + direction_ * t; }
  /// Half a free flight on, or half of it.
  Vec3d outlook() const { return point(near_ + std::min(far_ - near_, 1 / density_) / 2); }
  /// The share of light that does not come through.
  double taken() const { return taken_; }
  /// The density with which the fog meets light that comes from its beginning.
  double met(double t) const { return density_ * exp_of(-density_ * (t - near_)); }

  /// Where the fog meets light that does not come through: with density met(t) / taken().
  double within(double u) const { return held(near_ + depth_of(u * taken_) / density_); }
  /// How far a path goes before the fog scatters it: beyond `far` where it comes through, which an
  /// open line lets none; met(t) / flight_weight() dense.
  double flight(double u) const { return open_ ? within(u) : near_ + depth_of(u) / density_; }
  /// What a path counts that is scattered so.
  double flight_weight() const { return open_ ? taken_ : 1; }

  /// View: of the line from a point. It draws evenly by the angle, so that the square of the
  /// distance from the point falls out.
  /// Source: Kulla, Fajardo, "Importance sampling techniques for path tracing in participating
  /// media", Computer Graphics Forum 31(4) (2012).
  class View {
   public:
    View(const FogLine& line, const Vec3d& from) : line_(line) {
      const Vec3d way = from - line.origin_;
      foot_ = dot(way, line.direction_);
      // A ray through the point itself is treated as one that passes it closely.
      away_ = std::max(length(way - line.direction_ * foot_), 1e-4 * length(way) + 1e-30);
      begin_ = line.near_ - foot_;
      const double end = line.far_ - foot_;
      angle_ = std::isinf(end) ? atan2_of(away_, begin_)
                               : atan2_of(away_ * (end - begin_), away_ * away_ + begin_ * end);
    }
    double draw(double u) const {
      const double turned = tan_of(u * angle_), first = begin_ / away_;
      return line_.held(foot_ + away_ * ((first + turned) / (1 - first * turned)));
    }
    double pdf(double t) const {
      const double aside = t - foot_;
      return away_ / (angle_ * (away_ * away_ + aside * aside));
    }

   private:
    const FogLine& line_;
    double foot_, away_;  // where the line is nearest to the point, and how near
    double begin_;        // from there to its beginning
    double angle_;        // from its beginning to its end
  };

 private:
  double held(double t) const { return std::clamp(t, near_, far_); }
  // 1 - e^-x and -log(1 - x), also where x is far below 1.
  static double share_of(double x) {
    return x < 1e-4 ? x * (1 - x / 2 * (1 - x / 3)) : 1 - exp_of(-x);
  }
  static double depth_of(double x) {
    return x < 1e-4 ? x * (1 + x * (1.0 / 2 + x / 3)) : -log_of(1 - x);
  }

  Vec3d origin_, direction_;
  double near_, far_, density_, taken_;
  bool open_;
};

}  // namespace tia
