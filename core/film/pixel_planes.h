// PixelPlanes: what a picture's pixels are before they are filtered, number by number.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace tia {

/// PixelPlanes: means over samples of a pixel: its light, and what its rays find where they first
/// meet a surface. Shape: `count` planes of height x width; row 0 is the top.
struct PixelPlanes {
  /// Where each number stands; those of three channels stand side by side. `albedo` is what light
  /// is divided by. `depth` is any number that grows or falls with the distance.
  enum Plane { light = 0, albedo = 3, normal = 6, depth = 9, visibility = 10, count = 11 };

  int width = 0, height = 0;
  std::array<std::vector<float>, count> planes;

  PixelPlanes(int w, int h) : width(w), height(h) {
    for (std::vector<float>& plane : planes) plane.resize(size());
  }
  std::size_t size() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
};

/// HalfBuffers: a window of a picture, once by each half of every pixel's samples.
struct HalfBuffers {
  PixelPlanes a, b;
  int x0 = 0, y0 = 0;  ///< the window's corner in the picture. Domain: >= 0
};

}  // namespace tia
