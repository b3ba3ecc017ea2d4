// The cylindrical panorama: verticals stay straight.
#pragma once

#include <cmath>

#include "core/scene/pixel_cone.h"
#include "core/scene/projections/local_ray.h"
#include "core/scene/projections/seen_angle.h"

namespace tia {

/// CylindricalView: the picture is a piece of a cylinder around the eye, of radius 1: columns are
/// angles from the middle, rows heights.
struct CylindricalView {
  double half = 0;         ///< of the angle that it sees, radians
  double half_height = 0;  ///< of the picture, on the cylinder

  static CylindricalView of(const SeenAngle& seen) {
    const double square = seen.radians * (seen.height / seen.width);
    return {seen.radians / 2, seen.tall.value_or(square) / 2};
  }
  template <class S>
  LocalRay<S> ray(const Raster<S>& at) const {
    const auto turn = sincos_of(at.x * S(half));
    const Vec3<S> way{turn.sine, at.y * S(half_height), -turn.cosine};
    return {at_eye<S>(), normalize(way), always<S>()};
  }
  /// On the horizon.
  PixelCone cone(int width, int height) const {
    return {0, std::sqrt((2 * half / width) * (2 * half_height / height))};
  }
};

}  // namespace tia
