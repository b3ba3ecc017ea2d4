// A scene's bodies as the exact solver knows them: balls, and surfaces that stand still.
#pragma once

#include "core/motion/exact.h"
#include "core/motion/lowered.h"

namespace tia {

/// Domain: bodies and physics that outlive what is returned.
/// Returns: the world, and faults at `at`/physics: bodies that are no balls, or of a density that
/// tells no mass; surfaces that the solver does not know.
Lowered<ExactWorld> exact_world(const Physics& physics, const SceneBodies& bodies, const Place& at,
                                Faults& faults);

}  // namespace tia
