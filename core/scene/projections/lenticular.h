// What one colour of a lenticular panel shows: each of its subpixels another of a quilt's views.
#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "core/scene/pixel_cone.h"
#include "core/scene/projections/local_ray.h"

namespace tia {

/// LensSheet: which of `views` a subpixel shows, of the panel's point (x, y) in shares of its sides
/// from its bottom left corner: that in whose share of 0 to 1 the fraction of
/// (x + y tilt) pitch - center falls.
struct LensSheet {
  double pitch = 1, tilt = 0, center = 0;
  bool invert = false;
  int views = 1;

  int view_of(double x, double y) const {
    const double z = (x + y * tilt) * pitch - center;
    const double share = z - std::floor(z);
    const int view =
        static_cast<int>(share * views) < views ? static_cast<int>(share * views) : views - 1;
    return invert ? views - 1 - view : view;
  }
};

/// LenticularView: the rays of one colour of a panel's pixels: through the pixels' places in the
/// window at depth `focus`, each from the eye of the view that its subpixel shows.
struct LenticularView {
  LensSheet sheet;
  double across = 0;  ///< from a pixel's middle to this colour's, in shares of the width
  int width = 1, height = 1;
  double half_width = 1, half_height = 1;  ///< of the window, at depth 1
  double focus = 1;
  std::shared_ptr<const std::vector<double>> eyes{};  ///< of the views, along the right

  template <class S>
  LocalRay<S> ray(const Raster<S>& at) const {
    const S eye = eye_of(at);
    const Vec3<S> way{at.x * S(half_width) - eye / S(focus), at.y * S(half_height), S(-1.0)};
    return {{eye, S(0.0), S(0.0)}, normalize(way), always<S>()};
  }
  PixelCone cone(int, int) const {
    return {0, std::sqrt((2 * half_width / width) * (2 * half_height / height))};
  }

 private:
  // A pixel's rays all show one view, wherever in the pixel they go.
  static double middle(double at, int size) {
    const double pixel = std::floor((at + 1) / 2 * size);
    return ((pixel < 0 ? 0 : pixel < size ? pixel : size - 1) + 0.5) / size;
  }
  double eye_of(const Raster<double>& at) const {
    const double x = middle(at.x, width) + across, y = middle(at.y, height);
    return (*eyes)[static_cast<std::size_t>(sheet.view_of(x, y))];
  }
  Octet eye_of(const Raster<Octet>& at) const {
    double x[Octet::size], y[Octet::size], eye[Octet::size];
    at.x.store_unaligned(x), at.y.store_unaligned(y);
    for (std::size_t i = 0; i < Octet::size; ++i) eye[i] = eye_of(Raster<double>{x[i], y[i]});
    return Octet::load_unaligned(eye);
  }
};

}  // namespace tia
