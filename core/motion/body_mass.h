// What a body weighs, as it is said: its mass, or its volume times its density.
#pragma once

#include "core/motion/bodies.h"

namespace tia {

/// Domain: a body whose object was found. `at` is its row.
/// Returns: 1 and a fault at `at`/density where the shape's volume is not known.
double mass_of(const MovingBody& body, const Place& at, Faults& faults);

}  // namespace tia
