// The equirectangular panorama: all around, longitude across and latitude up.
#pragma once

#include <cmath>

#include "core/scene/pixel_cone.h"
#include "core/scene/projections/local_ray.h"
#include "core/scene/projections/seen_angle.h"

namespace tia {

/// EquirectangularView: column x looks along the azimuth ((x + 1/2) / W - 1/2) 360 degrees, to the
/// right positive, row y up by 90 - (y + 1/2) / H 180 degrees. With `aside`, the rays of a column
/// start on the circle of that radius, to the right, tangentially: of an eye of a head that turns.
/// Source: Ishiguro, Yamamoto and Tsuji, "Omni-directional stereo", IEEE PAMI 14(2), 1992.
struct EquirectangularView {
  double aside = 0;

  static EquirectangularView of(const SeenAngle&) { return {}; }
  template <class S>
  LocalRay<S> ray(const Raster<S>& at) const {
    const auto turn = sincos_of(at.x * S(pi));
    const auto rise = sincos_of(at.y * S(pi / 2));
    const Vec3<S> eye{turn.cosine * S(aside), S(0.0), turn.sine * S(aside)};
    return {eye, {turn.sine * rise.cosine, rise.sine, -(turn.cosine * rise.cosine)}, always<S>()};
  }
  /// On the horizon.
  PixelCone cone(int width, int height) const {
    return {0, std::sqrt((2 * pi / width) * (pi / height))};
  }
};

}  // namespace tia
