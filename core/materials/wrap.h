// What a texture is outside of its picture.
#pragma once

#include <cstdint>

namespace tia {

/// Wrap: what a texture is outside of [0, 1], along one of its coordinates.
enum class Wrap : std::uint8_t { repeat, mirrored_repeat, clamp_to_edge };

}  // namespace tia
