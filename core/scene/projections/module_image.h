// The image of one projector of an array behind a screen: the inverse of the rays that it sends.
#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "core/scene/pixel_cone.h"
#include "core/scene/projections/local_ray.h"

namespace tia {

/// ScreenWarp: where on the screen the points of a module's image are, bilinear between those of a
/// grid of columns x rows points across the image, row by row from the top. What is kept is how far
/// each is from where it would be, so that a warp that changes nothing changes no bit.
/// Space/units: the display's, x right and y up from the screen's middle.
struct ScreenWarp {
  int columns = 2, rows = 2;
  std::vector<std::array<double, 2>> off{};

  /// At the image's point (u, v), from 0 to 1, v downwards.
  std::array<double, 2> at(double u, double v) const;
};

/// ModuleImage: of the module at x = `module`, z = -behind, whose screen lies in z = 0; viewers'
/// eyes are on the line y = eye_height, z = distance. The light that leaves the screen's point
/// (x, y) has the direction ((x - module) / behind, (eye_height - y) / distance, 1), and the ray is
/// its inverse, from where it crosses the viewers' line. Origin of the frame: the screen's middle.
/// Source: Balogh, Forgacs, Agocs, Balet, Bouvier, Bettio, Gobbetti, Zanetti, "A scalable hardware
/// and software system for the holographic display of interactive graphics applications",
/// Eurographics short papers, 2005.
struct ModuleImage {
  double module = 0, behind = 1, distance = 1, eye_height = 0;
  double half_width = 1, half_height = 1;  ///< of the screen
  std::shared_ptr<const ScreenWarp> warp{};

  template <class S>
  LocalRay<S> ray(const Raster<S>& at) const {
    S x = at.x * S(half_width), y = at.y * S(half_height);
    if (warp) shift(at, x, y);
    return through(x, y, S(module));
  }
  /// Through a point of the screen, of the module there.
  template <class S>
  LocalRay<S> through(const S& x, const S& y, const S& from) const {
    const S slope = (x - from) / S(behind), drop = (S(eye_height) - y) / S(distance);
    const Vec3<S> origin{x + slope * S(distance), S(eye_height), S(distance)};
    return {origin, normalize(Vec3<S>{-slope, -drop, S(-1.0)}), always<S>()};
  }
  /// On the screen, where the rays of neighbours are a pixel of it apart.
  PixelCone cone(int width, int height) const {
    return {std::sqrt((2 * half_width / width) * (2 * half_height / height)), 0};
  }

 private:
  template <class S>
  void shift(const Raster<S>& at, S& x, S& y) const;
};

}  // namespace tia
