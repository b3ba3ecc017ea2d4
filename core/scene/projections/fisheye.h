// The fisheye: a part of the sphere as a disc, as domes of planetariums are fed.
#pragma once

#include "core/scene/pixel_cone.h"
#include "core/scene/projections/local_ray.h"
#include "core/scene/projections/seen_angle.h"

namespace tia {

/// FisheyeView: equidistant, r = f theta: a point at r halves of the shorter side from the
/// picture's middle looks half * r off the axis. Outside of the disc there is no ray.
/// Source: Kannala and Brandt, "A generic camera model", IEEE PAMI 28(8), 2006, eq. 3.
struct FisheyeView {
  double half = 0;            ///< of the angle across the disc, radians
  double wide = 1, tall = 1;  ///< the picture's halves in halves of the shorter side

  static FisheyeView of(const SeenAngle& seen) {
    const double shorter = seen.width < seen.height ? seen.width : seen.height;
    return {seen.radians / 2, seen.width / shorter, seen.height / shorter};
  }
  template <class S>
  LocalRay<S> ray(const Raster<S>& at) const {
    using std::sqrt;
    const S x = at.x * S(wide), y = at.y * S(tall);
    const S r = sqrt(x * x + y * y);
    const auto [sine, cosine] = sincos_of(r * S(half));
    const S along = select(r > S(0.0), sine / r, S(half));
    return {at_eye<S>(), {x * along, y * along, -cosine}, r <= S(1.0)};
  }
  /// Along a radius; across it pixels are no wider.
  PixelCone cone(int width, int height) const {
    return {0, 2 * half / (width < height ? width : height)};
  }
};

}  // namespace tia
