// A scene's bodies as a solver knows them: its world, and whose each of its fixed parts is.
#pragma once

#include <cstddef>
#include <vector>

#include "core/motion/bodies.h"

namespace tia {

/// WorldNumbers: in a solver's world bodies come first, as in SceneBodies, then the parts of what
/// is fixed, of which a row of `fixed` may have several: a group has.
struct WorldNumbers {
  std::size_t bodies = 0;
  std::vector<std::size_t> row_of_part;

  /// A number of the world's as SceneBodies has it.
  std::size_t operator()(std::size_t in_world) const {
    return in_world < bodies ? in_world : bodies + row_of_part[in_world - bodies];
  }
};

template <class World>
struct Lowered {
  World world;
  WorldNumbers numbers;
};

/// The solver's world of a scene's bodies: add_body(body, place, world) adds one or tells its
/// fault; add_fixed(object, parent, world.fixed) adds parts, and is false where the solver does not
/// know the shape, but `known_fixed`. Domain: physics and bodies that outlive what is returned.
template <class World, class AddBody, class AddFixed>
Lowered<World> lowered(const Physics& physics, const SceneBodies& bodies, const Place& at,
                       Faults& faults, const AddBody& add_body, const AddFixed& add_fixed,
                       const char* known_fixed) {
  const Place physics_at = at.at("physics");
  const Place all_bodies = physics_at.at("bodies"), all_fixed = physics_at.at("fixed");
  Lowered<World> made;
  World& world = made.world;
  world.gravity = physics.gravity;
  world.duration = physics.duration;
  made.numbers.bodies = bodies.bodies.size();
  for (std::size_t i = 0; i < bodies.bodies.size() && !faults.full(); ++i)
    add_body(bodies.bodies[i], all_bodies.at(i), world);
  for (std::size_t i = 0; i < bodies.fixed.size() && !faults.full(); ++i) {
    const FixedBody& fixed = bodies.fixed[i];
    if (fixed.what.object != nullptr &&
        !add_fixed(*fixed.what.object, fixed.what.parent, world.fixed))
      faults.add({FaultKind::conflict, all_fixed.at(i).at("object").pointer(),
                  Value(fixed.said->object), known_fixed});
    made.numbers.row_of_part.resize(world.fixed.size(), i);
  }
  world.restitution = [&bodies, numbers = made.numbers](std::size_t a, std::size_t b) {
    return bodies.restitution(numbers(a), numbers(b));
  };
  return made;
}

}  // namespace tia
