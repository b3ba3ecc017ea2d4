// The open time of a frame: its strata, and the scene whose moments they are.
#pragma once

#include <vector>

#include "core/scene/scene.h"

namespace tia {

/// The middles of `steps` equal strata of the time for which the shutter is open around a frame's,
/// ascending: seconds + shutter/fps ((i + 0.5)/steps - 0.5); none before the beginning or after the
/// end, unless a track repeats, which goes on there (own_time). Space/units: seconds.
std::vector<double> stratum_times(const Animation& animation, double seconds, int steps);

/// The scene of whose strata a frame is the mean: the moving one, where what the frame has but
/// once, title, description, backdrop, shadow_ground, sheet and options, is that of its own moment,
/// and does not move.
Scene exposed_scene(const Scene& moving, const Scene& frame);

/// Whether a track has another value at one of these times than at another, or none.
bool moves_within(const Animation& animation, const std::vector<double>& times);

}  // namespace tia
