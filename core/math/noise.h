// Ken Perlin's improved gradient noise and the turbulence made of it.
#pragma once

#include "core/math/vec3.h"

namespace tia {

/// Gradient noise: 0 wherever x, y and z are integers, smooth, in [-1.037, 1.037], the same 256
/// further on along every axis. NaN where a coordinate is none.
/// Source: K. Perlin, "Improving Noise", SIGGRAPH 2002, with the permutation of his reference
/// implementation.
double gradient_noise(const Vec3d& p);

/// The octaves of turbulence: 1, 1/2, ... 1/32 of the size.
inline constexpr int turbulence_octaves = 6;

/// Returns: the sum of |gradient_noise(2^i p)| / 2^i over the octaves; at least 0, below 2.1.
/// Source: K. Perlin, "An Image Synthesizer", SIGGRAPH 1985, "turbulence".
double turbulence_at(const Vec3d& p);

}  // namespace tia
