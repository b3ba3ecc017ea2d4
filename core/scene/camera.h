// The camera as the scene writes it, and the view that every spelling of it becomes.
#pragma once

#include <optional>

#include "core/input/errors.h"
#include "core/input/fields.h"
#include "core/math/ray.h"

namespace tia {

/// Camera: `location` with `look_at` or `direction`, `up` and `fov_degrees`; or the slides' view
/// plane, where `direction` runs to the plane's centre and `up` and `right` from there to its
/// edges. Space/units: world space, scene units. Default: at the origin, looking along -z.
struct Camera {
  Vec3d location{};
  std::optional<Vec3d> look_at, direction;
  Vec3d up{0, 1, 0};
  std::optional<Vec3d> right;
  double fov_degrees = 25;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    constexpr double far = 1e9;
    visit("location", &Camera::location, Spec{.about = "the eye", .min = -far, .max = far});
    visit("look_at", &Camera::look_at,
          Spec{.about = "the point in the picture's centre", .min = -far, .max = far});
    visit("direction", &Camera::direction,
          Spec{.about = "the way the eye looks; with right, up to the view plane's centre",
               .min = -far,
               .max = far});
    visit("up", &Camera::up,
          Spec{.about = "what is up; with right, half the view plane's height",
               .min = -far,
               .max = far});
    visit("right", &Camera::right,
          Spec{.about = "half the view plane's width", .min = -far, .max = far});
    visit("fov_degrees", &Camera::fov_degrees,
          Spec{.about = "vertical field of view",
               .unit = "degrees",
               .min = 0,
               .max = 179,
               .open_min = true});
  }
  /// Conflicting spellings, zero lengths, an `up` along the view.
  void check(const Place& at, Faults& faults) const;
  bool operator==(const Camera&) const = default;
};

/// View: the eye and the plane it looks through. The ray of a raster point (sx, sy) in [-1,1]^2,
/// sy upwards, runs along forward + sx * right + sy * up.
struct View {
  Vec3d origin, forward, right, up;
  int width = 0, height = 0;

  /// The ray through the centre of pixel (x, y), row 0 on top, as the sum of what its column and
  /// its row give. Exactly symmetric about both axes.
  /// Source: algorithm of the thesis, xx = (2x+1-W)/W * tan(fov/2) * W/H, yy likewise.
  template <class Real>
  Ray<Real> ray(Real x, Real y) const {
    return {lift<Real>(origin), normalize(column(x) + row(y))};
  }
  template <class Real>
  Vec3<Real> column(Real x) const {
    const Real w = Real(static_cast<float>(width));
    return lift<Real>(forward) + lift<Real>(right) * ((x + x + Real(1) - w) / w);
  }
  template <class Real>
  Vec3<Real> row(Real y) const {
    const Real h = Real(static_cast<float>(height));
    return lift<Real>(up) * ((h - (y + y) - Real(1)) / h);
  }
};

/// Beam: a cone around all rays from the eye through one rectangle of the picture, those of float
/// with all their roundings included. What is culled with it is only what no ray of it can meet, so
/// that no pixel depends on it.
class Beam {
 public:
  /// The rays of the pixels x0 <= x < x1, y0 <= y < y1.
  Beam(const View& view, int x0, int y0, int x1, int y1);
  /// False only if no ray of the beam meets the ball.
  bool may_meet(const Vec3d& center, double radius) const;

 private:
  Vec3d origin_, axis_;
  double cos_spread_ = 1, sin_spread_ = 0;  // of the angle between the axis and the outermost ray
  double eye_blur_ = 0;                     // how far a float eye may lie from the exact one
};

/// Domain: a camera that its check has passed.
View view_of(const Camera& camera, int width, int height);

}  // namespace tia
