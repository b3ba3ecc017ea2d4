// The picture as the eye that looks at a point of it has it: angles from there, and around.
#pragma once

#include <array>

#include "core/math/lanes.h"
#include "core/render/window.h"
#include "core/scene/view.h"

namespace tia {

/// Polar: where a direction is. Space/units: `eccentricity` in radians from the gaze, 0 .. pi;
/// `turn` around it, in turns from the picture's right towards its top, 0 .. 1.
template <class Real>
struct Polar {
  Real eccentricity, turn;
};

/// GazeFrame: of a perspective view and a point that is looked at, in pixels from its corner.
class GazeFrame {
 public:
  GazeFrame(const View& view, double x, double y);

  /// The way to a point of the raster, of any length. Space/units: as the view's.
  Vec3d toward(double x, double y) const { return corner_ + right_ * x + down_ * y; }
  /// The angle between the way to it and the gaze. Space/units: radians.
  double eccentricity(const Vec3d& way) const;
  /// The angle that a pixel's height spans, between the middles of its upper and lower edge.
  double size_of_pixel(int x, int y) const { return height_at(x + 0.5, y); }
  /// That of a pixel in the picture's centre; and more than that of any pixel.
  double size_in_centre() const;
  double most_size() const;

  /// The ways at an eccentricity and a turn: there, away from the gaze, and along the ring. Unit.
  struct Place {
    Vec3d direction, outwards, along;
  };
  Place place(double eccentricity, double turn) const;

  /// Where the centre of a pixel is that is so far from the gaze, in pixels to the right and
  /// downwards. The same bits in lanes and one by one; within 1e-6 of the angle.
  template <class Real>
  Polar<Real> polar(const Real& dx, const Real& dy) const;
  double x() const { return x_; }
  double y() const { return y_; }

  /// A vector's shares along right, up and the gaze.
  Vec3d in_frame(const Vec3d& v) const {
    return {dot(v, across_), dot(v, upwards_), dot(v, gaze_)};
  }

 private:
  double height_at(double x, double top) const;

  double x_, y_;
  int width_, height_;
  Vec3d corner_, right_, down_;     // the raster's corner, and a pixel's sides
  Vec3d gaze_, across_, upwards_;   // unit and perpendicular
  double to_gaze_;                  // how long the way to the point is
  Vec3d pixel_right_, pixel_down_;  // a pixel's sides, in that frame
};

/// The four planes through the eye that bound a window: what it shows has no negative distance from
/// them. Space/units: normals in the gaze's frame, unit.
std::array<Vec3d, 4> planes_around(const GazeFrame& frame, const Window& window);

/// More than any eccentricity in a window.
double most_eccentricity(const GazeFrame& frame, const Window& window);

// ---- angles in lanes ----------------------------------------------------------------------------

/// The angle of the point (x, y) from x, in turns, for y >= 0. Returns: 0 .. 0.5, within 1e-7.
/// Source: Hastings' polynomial, Abramowitz and Stegun, "Handbook of mathematical functions", 1964,
/// 4.4.49, of an error below 2e-8.
template <class Real>
Real half_turn(const Real& y, const Real& x) {
  const Real across = abs_of(x);
  const Real less = min_of(y, across), more = max_of(y, across);
  const Real t = less / max_of(more, Real(1e-37F)), s = t * t;
  Real sum(0.0028662257F);
  for (const float a : {-0.0161657367F, 0.0429096138F, -0.0752896400F, 0.1065626393F,
                        -0.1420889944F, 0.1999355085F, -0.3333314528F, 1.0F})
    sum = sum * s + Real(a);
  const Real first = t * sum * Real(0.15915494F);  // an eighth of a turn at most
  const Real quarter = select(y > across, Real(0.25F) - first, first);
  return select(x < Real(0), Real(0.5F) - quarter, quarter);
}

template <class Real>
Polar<Real> GazeFrame::polar(const Real& dx, const Real& dy) const {
  using std::sqrt;  // Wide brings its own
  const auto share = [&](double right, double down) {
    return lift<Real>(right) * dx + lift<Real>(down) * dy;
  };
  const Real a = share(pixel_right_.x, pixel_down_.x), b = share(pixel_right_.y, pixel_down_.y);
  const Real c = lift<Real>(to_gaze_) + share(pixel_right_.z, pixel_down_.z);
  const Real half = half_turn(abs_of(b), a);
  const Real turn = select(b < Real(0), Real(1) - half, half);
  constexpr float around = 6.2831853F;
  return {half_turn(sqrt(a * a + b * b), c) * Real(around), min_of(turn, Real(0.99999994F))};
}

}  // namespace tia
