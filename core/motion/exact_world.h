// A scene's bodies as the exact solver knows them: balls, and surfaces that stand still.
#pragma once

#include "core/motion/bodies.h"
#include "core/motion/exact.h"

namespace tia {

/// LoweredExact: the world, and of each of its fixed surfaces the number of the row of `fixed` that
/// it belongs to: a group is several.
struct LoweredExact {
  ExactWorld world;
  std::vector<std::size_t> row_of_fixed;

  /// A number of the world's as SceneBodies has it.
  std::size_t number_of(std::size_t in_world) const;
};

/// Domain: bodies and physics that outlive what is returned.
/// Returns: the world, and faults at `at`/physics: bodies that are no balls, or of a density that
/// tells no mass; surfaces that the solver does not know.
LoweredExact exact_world(const Physics& physics, const SceneBodies& bodies, const Place& at,
                         Faults& faults);

}  // namespace tia
