// What an animation's channels say at a time.
#pragma once

#include <vector>

#include "core/models/model.h"

namespace tia {

/// Seconds of its last key; 0 without one.
double duration_of(const ModelAnimation& animation);

/// A channel's numbers at a time: before its first key that key's, after its last the last's;
/// rotations are quaternions of length 1. Shape: as one time of `values`, of a cubic spline a
/// third. Domain: check_model's. Source: glTF 2.0, 3.11 and appendix C (slerp the short way, cubic
/// Hermite splines with tangents scaled by the time between keys).
std::vector<double> sampled(const AnimationChannel& channel, double seconds);

}  // namespace tia
