// How far a material covers what is behind it, in glTF's words.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "core/input/fields.h"

namespace tia {

/// AlphaMode: what alpha means. opaque: nothing; mask: there is nothing where it is below a cutoff;
/// blend: its share of every ray meets the surface, and the rest goes straight on.
enum class AlphaMode : std::uint8_t { opaque, mask, blend };
template <>
struct Names<AlphaMode> {
  static constexpr std::array<std::string_view, 3> names{"opaque", "mask", "blend"};
};

/// AlphaUse: a mode with its cutoff.
struct AlphaUse {
  AlphaMode mode = AlphaMode::opaque;
  double cutoff = 0.5;
};
/// The share of rays that meets a surface of that alpha. Source: Khronos, glTF 2.0 (2021), 3.9.4.
inline double opacity_of(const AlphaUse& use, double alpha) {
  if (use.mode == AlphaMode::mask) return alpha < use.cutoff ? 0 : 1;
  return use.mode == AlphaMode::blend ? alpha : 1;
}

}  // namespace tia
