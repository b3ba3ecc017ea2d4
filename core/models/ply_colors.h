// Colours of vertices as PLY files store them.
#pragma once

#include <vector>

#include "core/models/ply_header.h"

namespace tia {

/// PlyColors: stored colours as linear light. Whole numbers are sRGB signals, shares of the largest
/// number of their type; of alpha just shares. What is stored as a float is linear.
class PlyColors {
 public:
  /// Whether colours of a type are taken: uint8, uint16, float32 and float64.
  static bool takes(PlyType type) {
    return type == PlyType::uint8 || type == PlyType::uint16 || !is_whole(type);
  }
  /// Domain: a type that is taken.
  float linear(PlyType type, double stored);
  static float alpha(PlyType type, double stored);

 private:
  // Light by its code, below 0 where it was not asked for yet: all of 65536 would cost 10 ms.
  std::vector<float> of_bytes_, of_words_;
};

}  // namespace tia
