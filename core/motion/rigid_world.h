// A scene's bodies as the rigid solver knows them.
#pragma once

#include "core/motion/bodies.h"
#include "core/motion/rigid.h"

namespace tia {

/// LoweredRigid: the world, and of each fixed part the number of the row of `fixed` that it belongs
/// to: a group is several.
struct LoweredRigid {
  RigidWorld world;
  std::vector<std::size_t> row_of_fixed;

  /// A number of the world's as SceneBodies has it.
  std::size_t number_of(std::size_t in_world) const;
};

/// Domain: bodies and physics that outlive what is returned.
/// Returns: the world, and faults at `at`/physics: shapes that the solver does not know, meshes
/// that move and are not closed, masses that a density does not tell.
LoweredRigid rigid_world(const Physics& physics, const SceneBodies& bodies, const Place& at,
                         Faults& faults);

}  // namespace tia
