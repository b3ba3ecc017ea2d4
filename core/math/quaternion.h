// Rotations as quaternions x, y, z, w, as glTF writes them.
#pragma once

#include <array>

#include "core/math/transform.h"

namespace tia {

/// Quaternion: x, y, z = axis sin(angle/2), w = cos(angle/2), all times any length but 0.
using Quaternion = std::array<double, 4>;

/// The same rotation by a quaternion of length 1; of length 0 none at all.
Quaternion normalized(const Quaternion& q);

/// The rotation. Domain: a length other than 0.
Affine rotation_of(const Quaternion& q);

/// From a to b at constant speed, the short way; `share` 0 is a, 1 is b. Returns: length 1.
/// Source: Shoemake, "Animating rotation with quaternion curves" (1985), section 3.3.
Quaternion slerp(const Quaternion& a, const Quaternion& b, double share);

}  // namespace tia
