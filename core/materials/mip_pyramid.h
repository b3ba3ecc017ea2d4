// MipPyramid: a picture, and the same ever smaller, for looking at it from afar.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/film/image.h"
#include "core/film/tonemap.h"

namespace tia {

/// Rgba: linear light and alpha, each 0 .. 1.
using Rgba = std::array<double, 4>;

/// MipPyramid: level 0 is the picture, each next level has half its sides, rounded down, until both
/// are 1. A texel of a level is the mean, in linear light, of what it covers of the level before:
/// a box filter, with weights by area where a side is odd, so that every level has the same mean.
/// Source: Williams, "Pyramidal parametrics", SIGGRAPH 1983.
class MipPyramid {
 public:
  /// Domain: a picture of 1 pixel at least. `encoding`: how its codes but alpha's mean light.
  /// `halves`: whether there are levels beyond 0.
  /// Cost: 8 bytes a pixel of the levels beyond 0, which are a third of the picture's.
  MipPyramid(std::shared_ptr<const ImageRgba8> image, Encoding encoding, bool halves = true);

  int levels() const { return static_cast<int>(halves_.size()) + 1; }
  int width(int level) const;
  int height(int level) const;
  /// Domain: a texel of that level; row 0 is the top.
  Rgba texel(int level, int x, int y) const;

  /// With the picture's own bytes, though others share it.
  friend std::size_t heap_bytes(const MipPyramid& pyramid);

 private:
  struct Half {
    int width = 0, height = 0;
    std::vector<std::uint16_t> rgba;  // linear, 65535 is 1
  };
  Half half_of(int level) const;

  std::shared_ptr<const ImageRgba8> image_;
  const std::array<double, 256>* light_;  // of each code
  std::vector<Half> halves_;
};

/// What the levels beyond 0 of a picture of that size take. Space/units: bytes.
std::size_t bytes_of_halves(int width, int height);

}  // namespace tia
