// The view that every spelling of a camera becomes: which ray belongs to which point of the raster
// and of the lens. Which points are taken is render/sampler's.
#pragma once

#include <limits>

#include "core/math/ray.h"
#include "core/scene/projections/projection.h"

namespace tia {

struct Camera;

/// View: the eye and the plane that it looks through. The picture's point (sx, sy) in [-1,1]^2, sy
/// upwards, has the ray
///   perspective: from `origin` along forward + sx * right + sy * up, seen through a lens from
///     a point of the lens towards where the ray from its centre meets the plane of focus;
///   orthographic: from origin + sx * right + sy * up along `forward`;
///   any other: that of `curved`, in the frame of right, up (which then have length 1) and -axis.
/// An eye beside the middle of its window has the window's plane skew to `forward` (moved_eye).
/// Space/units: world space; `forward` has length 1, beside the middle along the axis.
struct View {
  Vec3d origin, forward, right, up;
  int width = 0, height = 0;
  Projection projection = Projection::perspective;
  Vec3d lens_right{}, lens_up{};  ///< the lens' radii, parallel to right and up; 0: a pinhole
  double focus_distance = 1;      ///< along forward; the plane of focus is parallel to the lens
  Vec3d axis{0, 0, -1};           ///< unit, perpendicular to right and up, on forward's side
  double near = 0, far = std::numeric_limits<double>::infinity();  ///< along it; what is seen
  CurvedView curved{};  ///< of what looks through no plane

  /// The same view in a space whose origin is there.
  View seen_from(const Vec3d& there) const {
    View view = *this;
    view.origin = origin - there;
    return view;
  }
  bool is_flat() const { return std::holds_alternative<FlatView>(curved); }
  bool orthographic() const { return projection == Projection::orthographic; }
  bool is_clipped() const { return near > 0 || far < std::numeric_limits<double>::infinity(); }
  bool has_lens() const { return lens_right != Vec3d{0, 0, 0}; }

  /// The ray through the centres of pixel (x, y), row 0 on top, and of the lens. Exactly symmetric
  /// about both axes. Domain: a pixel that has a ray (has_ray).
  /// Source: algorithm of the thesis, xx = (2x+1-W)/W * tan(fov/2) * W/H, yy likewise.
  template <class Real>
  Ray<Real> ray(Real x, Real y) const;
  /// What a column and a row give to their pixels' rays, as a sum: a direction, orthographic a
  /// point. Domain: flat.
  template <class Real>
  Vec3<Real> column(Real x) const {
    const Real w = Real(static_cast<float>(width));
    return lift<Real>(orthographic() ? origin : forward) +
           lift<Real>(right) * ((x + x + Real(1) - w) / w);
  }
  template <class Real>
  Vec3<Real> row(Real y) const {
    const Real h = Real(static_cast<float>(height));
    return lift<Real>(up) * ((h - (y + y) - Real(1)) / h);
  }
};

/// Aim: where in a pixel and on the lens a ray goes. Space/units: dx and dy in pixels from the
/// pixel's centre, to the right and downwards; the lens' point in its radii, inside the unit disc.
template <class Real>
struct Aim {
  Real dx, dy, lens_x, lens_y;
};

/// Eye: a view's constants, rounded to the scalar once.
template <class Real>
class Eye {
 public:
  explicit Eye(const View& view)
      : orthographic_(view.orthographic()),
        has_lens_(view.has_lens()),
        origin_(lift<Real>(view.origin)),
        forward_(lift<Real>(view.forward)),
        pixel_right_(lift<Real>(view.right * (2.0 / view.width))),
        pixel_down_(lift<Real>(view.up * (-2.0 / view.height))),
        lens_right_(lift<Real>(view.lens_right)),
        lens_up_(lift<Real>(view.lens_up)),
        focus_right_(lift<Real>(view.lens_right * (1 / view.focus_distance))),
        focus_up_(lift<Real>(view.lens_up * (1 / view.focus_distance))) {}

  /// The ray of a pixel's column plus its row.
  Ray<Real> ray(const Vec3<Real>& at) const {
    if (orthographic_) return {at, forward_};
    return {origin_, normalize(at)};
  }
  Ray<Real> ray(const Vec3<Real>& center, const Aim<Real>& aim) const {
    const Vec3<Real> at = center + (pixel_right_ * aim.dx + pixel_down_ * aim.dy);
    if (!has_lens_) return ray(at);
    const Vec3<Real> from_center = focus_right_ * aim.lens_x + focus_up_ * aim.lens_y;
    return {origin_ + (lens_right_ * aim.lens_x + lens_up_ * aim.lens_y),
            normalize(at - from_center)};
  }

 private:
  bool orthographic_, has_lens_;
  Vec3<Real> origin_, forward_, pixel_right_, pixel_down_;
  Vec3<Real> lens_right_, lens_up_, focus_right_, focus_up_;  // the lens', and per focus_distance
};

/// SeenRay: the ray of a picture's point, where there is one: of a fisheye outside of its disc,
/// none.
template <class Real>
struct SeenRay {
  Ray<Real> ray;
  Mask<Real> seen;
};

/// The ray of a view that is not flat, computed in double for every scalar, and rounded once.
/// (dx, dy): from the centre of pixel (x, y), as Aim's.
template <class Real>
SeenRay<Real> curved_ray(const View& view, const Real& x, const Real& y, const Real& dx,
                         const Real& dy);
/// The same of any view.
template <class Real>
SeenRay<Real> seen_ray(const View& view, const Real& x, const Real& y, const Aim<Real>& aim) {
  if (!view.is_flat()) return curved_ray(view, x, y, aim.dx, aim.dy);
  return {Eye<Real>(view).ray(view.column(x) + view.row(y), aim), Real(0) < Real(1)};
}

template <class Real>
Ray<Real> View::ray(Real x, Real y) const {
  if (!is_flat()) return curved_ray(*this, x, y, Real(0), Real(0)).ray;
  return Eye<Real>(*this).ray(column(x) + row(y));
}

/// How wide a pixel in the view's middle sees; all its pixels have it.
PixelCone cone_of(const View& view);

/// The view from an eye that is moved across its axis and sees the same window in the plane at that
/// depth along the axis; orthographic, whose parallel rays go through that window.
/// Domain: a flat view; `by` perpendicular to the axis.
/// Source: Bourke, "Calculating stereo pairs", 1999, off-axis.
View moved_eye(const View& view, const Vec3d& by, double depth);

/// Domain: a camera that its check has passed (views.cpp, where a display's views are).
View view_of(const Camera& camera, int width, int height);

}  // namespace tia
