// Whether a scene's animation can be drawn at all of its times.
#pragma once

#include <stop_token>

#include "core/scene/scene.h"

namespace tia {

/// Tries an animation's moments: its beginning, its frames, the times of its keys and the ends of
/// intervals within its duration; of an animation that has so many that this would take seconds,
/// fewer of them, evenly, at least eight. Errors: InputError, of each place that has any its first
/// faults, as at_time tells them; Stopped.
void check_animation(const Scene& scene, const std::stop_token& stop = {});

}  // namespace tia
