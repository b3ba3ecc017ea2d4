// MipPyramid: a picture, and the same ever smaller, for looking at it from afar.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/film/image.h"
#include "core/film/tonemap.h"
#include "core/math/quad.h"

namespace tia {

/// Rgba: linear light and alpha, each 0 .. 1.
using Rgba = std::array<double, 4>;

/// Returns: four codes / 65535, to the bit, without dividing: the sum of code / 2^16 + code / 2^32
/// +
/// ..., of which the first three terms are exact together. A test tries all codes.
inline Quad light_of_half(const std::uint16_t* codes) {
  constexpr double first = 0x100010001p-48, rest = 0x1p-64 / (1 - 0x1p-16);
  const Quad all = quad_of(codes);
  return all * Quad(first) + all * Quad(rest);
}

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
  int width(int level) const { return level == 0 ? image_->width : half(level).width; }
  int height(int level) const { return level == 0 ? image_->height : half(level).height; }
  /// Domain: a texel of that level; row 0 is the top.
  Rgba texel(int level, int x, int y) const {
    return doubles_of(texel(level, place(width(level), x, y)));
  }
  /// Where in the list of its level a texel is.
  static std::size_t place(int width, int x, int y) {
    return 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                static_cast<std::size_t>(x));
  }
  /// Domain: the place of one of that level's.
  Quad texel(int level, std::size_t place) const {
    return level == 0 ? of_codes(&image_->rgba[place]) : light_of_half(&half(level).rgba[place]);
  }

  /// With the picture's own bytes, though others share it.
  friend std::size_t heap_bytes(const MipPyramid& pyramid);

 private:
  struct Half {
    int width = 0, height = 0;
    std::vector<std::uint16_t> rgba;  // linear, 65535 is 1
  };
  const Half& half(int level) const { return halves_[static_cast<std::size_t>(level) - 1]; }
  Half half_of(int level) const;
  Quad of_codes(const std::uint8_t* code) const {
    const std::array<double, 256>&light = *light_, &share = *shares_;
    return quad_of(light[code[0]], light[code[1]], light[code[2]], share[code[3]]);
  }

  std::shared_ptr<const ImageRgba8> image_;
  const std::array<double, 256>*light_, *shares_;  // of each code; of alpha's
  std::vector<Half> halves_;
};

/// What the levels beyond 0 of a picture of that size take. Space/units: bytes.
std::size_t bytes_of_halves(int width, int height);

}  // namespace tia
