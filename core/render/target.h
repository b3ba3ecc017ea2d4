// Rays that belong to no pixel.
#pragma once

#include <cstdint>

#include "core/math/vec3.h"

namespace tia {

/// Target: where rays go that are of no pixel: along `direction`, and where there are several up to
/// half of `right` and `down` beside. Its numbers are those that random ones are drawn for.
struct Target {
  Vec3d direction, right, down;
  std::uint32_t x, y;
};

}  // namespace tia
