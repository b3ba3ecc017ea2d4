// A scene's bodies as the rigid solver knows them.
#pragma once

#include "core/motion/lowered.h"
#include "core/motion/rigid.h"

namespace tia {

/// Domain: bodies and physics that outlive what is returned.
/// Returns: the world, and faults at `at`/physics: shapes that the solver does not know, meshes
/// that move and are not closed, masses that a density does not tell.
Lowered<RigidWorld> rigid_world(const Physics& physics, const SceneBodies& bodies, const Place& at,
                                Faults& faults);

}  // namespace tia
