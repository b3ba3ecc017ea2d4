// FogLine: distances along a ray through fog, drawn where it scatters light.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/lights/lit_spans.h"
#include "core/math/deterministic.h"
#include "core/math/powers.h"
#include "core/math/vec3.h"

namespace tia {

/// FogLine: the part of a ray that lies in homogeneous fog, from the distance `near` to `far`,
/// which may be infinite, or what a light shines on of that.
/// Domain: a unit direction; 0 <= near < far; density > 0.
class FogLine {
  /// `passed` is the share of light that comes to its beginning, `taken` what is met of that.
  struct Part {
    double near, far, passed, taken;
  };

 public:
  /// `open`: whether nothing lies behind it, and each path is scattered in it.
  FogLine(const Vec3d& origin, const Vec3d& direction, double near, double far, double density,
          bool open = false)
      : origin_(origin),
        direction_(direction),
        near_(near),
        far_(far),
        density_(density),
        open_(open) {
    add(near, far);
  }
  /// What a light shines on of it; distances are drawn from that alone.
  FogLine lit_by(const LitSpans& spans) const {
    FogLine lit = *this;
    if (spans.has(near_, far_)) return lit;
    lit.count_ = 0, lit.taken_ = 0;
    for (const auto& [from, to] : spans) lit.add(std::max(from, near_), std::min(to, far_));
    return lit;
  }

  const Vec3d& origin() const { return origin_; }
  const Vec3d& direction() const { return direction_; }
  Vec3d point(double t) const { return origin_ + direction_ * t; }
  /// Half a free flight on, or half of it.
  Vec3d outlook() const { return point(near_ + std::min(far_ - near_, 1 / density_) / 2); }
  /// The share of light that does not come through, but is met here.
  double taken() const { return taken_; }
  /// The density with which the fog meets light that comes from its beginning.
  double met(double t) const { return density_ * exp_of(-density_ * (t - near_)); }
  /// Whether it is lit there.
  bool has(double t) const {
    return std::any_of(parts_.begin(), parts_.begin() + count_,
                       [&](const Part& part) { return part.near <= t && t <= part.far; });
  }

  /// Where the fog meets light that does not come through: with density met(t) / taken().
  double within(double u) const {
    double left = u * taken_;
    const Part* part = parts_.data();
    for (; part + 1 < parts_.data() + count_ && left >= part->taken; ++part) left -= part->taken;
    return held(part->near + depth_of(left / part->passed) / density_, *part);
  }
  /// How far a path goes before the fog scatters it: beyond `far` where it comes through, which an
  /// open line lets none; met(t) / flight_weight() dense. Domain: the whole line.
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
      for (std::ptrdiff_t i = 0; i < line.count_; ++i) angle_ += angles_[at(i)] = angle_of(i);
    }
    double draw(double u) const {
      double turned = u * angle_;
      std::ptrdiff_t i = 0;
      for (; i + 1 < line_.count_ && turned >= angles_[at(i)]; ++i) turned -= angles_[at(i)];
      const double slope = tan_of(turned), first = (part(i).near - foot_) / away_;
      return held(foot_ + away_ * ((first + slope) / (1 - first * slope)), part(i));
    }
    /// 0 where the line is not lit.
    double pdf(double t) const {
      const double aside = t - foot_;
      return line_.has(t) ? away_ / (angle_ * (away_ * away_ + aside * aside)) : 0;
    }

   private:
    static std::size_t at(std::ptrdiff_t i) { return static_cast<std::size_t>(i); }
    const Part& part(std::ptrdiff_t i) const { return line_.parts_[at(i)]; }
    double angle_of(std::ptrdiff_t i) const {
      const double begin = part(i).near - foot_, end = part(i).far - foot_;
      return std::isinf(end) ? atan2_of(away_, begin)
                             : atan2_of(away_ * (end - begin), away_ * away_ + begin * end);
    }

    const FogLine& line_;
    double foot_, away_;              // where the line is nearest to the point, and how near
    std::array<double, 2> angles_{};  // that its parts fill
    double angle_ = 0;                // all of them
  };

 private:
  static double held(double t, const Part& part) { return std::clamp(t, part.near, part.far); }
  // 1 - e^-x and -log(1 - x), also where x is far below 1.
  static double share_of(double x) {
    return x < 1e-4 ? x * (1 - x / 2 * (1 - x / 3)) : 1 - exp_of(-x);
  }
  static double depth_of(double x) {
    return x < 1e-4 ? x * (1 + x * (1.0 / 2 + x / 3)) : -log_of(1 - x);
  }
  void add(double near, double far) {
    if (!(near < far)) return;
    const double passed = near > near_ ? exp_of(-density_ * (near - near_)) : 1;
    if (passed == 0) return;
    const double taken = passed * share_of(density_ * (far - near));
    parts_[static_cast<std::size_t>(count_++)] = {near, far, passed, taken};
    taken_ += taken;
  }

  Vec3d origin_, direction_;
  double near_, far_, density_;
  bool open_;
  std::array<Part, 2> parts_{};
  std::ptrdiff_t count_ = 0;
  double taken_ = 0;
};

}  // namespace tia
