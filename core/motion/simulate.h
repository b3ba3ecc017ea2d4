// From a scene with physics to the motion of its bodies, by the solver that it names.
#pragma once

#include <stop_token>

#include "core/input/errors.h"
#include "core/motion/simulation.h"

namespace tia {

/// Domain: a scene with physics; most_events > 0.
/// Errors: InputError: at `at`/physics what cannot take part, all of it at once; bodies that
/// overlap when they are first there, with both names and the time; more events than so many.
/// Stopped.
Simulation simulate(const Scene& scene, std::size_t most_events, const Place& at = {},
                    const std::stop_token& stop = {});

/// What can be said without solving. Errors: InputError as simulate. Stopped.
void check_physics(const Scene& scene, const Place& at = {}, const std::stop_token& stop = {});

}  // namespace tia
