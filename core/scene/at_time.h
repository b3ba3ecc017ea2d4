// A scene at a time: its animation resolved, a plain scene.
#pragma once

#include <stop_token>
#include <string>

#include "core/scene/keys.h"
#include "core/scene/scene.h"

namespace tia {

/// Whether a track moves the key light, as the parameter `light` does: the middles of the scene's
/// objects may matter then.
bool moves_key_light(const Animation& animation);

/// Whether a track changes what is hit, or what it wears.
bool moves_objects(const Animation& animation);

/// The plain scene of a time (of a track its own_time): the tracks' values put into its canonical
/// text, which is read again where they change it; without `animation`. Numbers are double, by + -
/// * / sqrt and deterministic functions. Errors: InputError, faults of all tracks at once: at
/// `at`/animation/tracks/i targets that are not there, hit twice or one inside the other; values
/// that the scene cannot have, and formulas that are not defined, with the time. Stopped. Domain: a
/// scene with an animation; middles_of(scene) where moves_key_light.
Scene at_time(const Scene& scene, double seconds, const Middles& middles, const Place& at = {},
              const std::stop_token& stop = {});

}  // namespace tia
