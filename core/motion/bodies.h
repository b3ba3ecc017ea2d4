// Bodies: the objects that a scene's physics names, found and placed. Which of them a solver can
// follow is the solver's own to say.
#pragma once

#include <limits>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/motion/placed_object.h"

namespace tia {

/// MovingBody: a row of `bodies` and its object.
struct MovingBody {
  const PhysicsBody* said = nullptr;
  PlacedObject what;
  double enters = 0, leaves = std::numeric_limits<double>::infinity();  ///< it is there in between
};
/// FixedBody: a row of `fixed` and its object.
struct FixedBody {
  const PhysicsFixed* said = nullptr;
  PlacedObject what;
};

/// SceneBodies: what takes part; bodies are numbered first, what is fixed after them.
struct SceneBodies {
  std::vector<MovingBody> bodies;
  std::vector<FixedBody> fixed;
  std::unordered_map<std::uint64_t, const PhysicsPair*> pairs;  ///< by both numbers

  std::size_t count() const { return bodies.size() + fixed.size(); }
  /// As its row calls it.
  const std::string& name_of(std::size_t number) const;
  /// Of a pair, by their numbers: what `pairs` says, else the product.
  double restitution(std::size_t a, std::size_t b) const;
  /// Of a pair: what `pairs` says, else the geometric mean.
  double friction(std::size_t a, std::size_t b) const;
  static std::uint64_t key_of(std::size_t a, std::size_t b);
};

/// Finds them. Domain: a scene with physics that outlives what is returned.
/// Returns: what could be found, and faults at `at`/physics: names that are not there, or of
/// several objects, or twice; objects that something else moves; parents that scale or repeat.
SceneBodies bodies_of(const Scene& scene, const Place& at, Faults& faults);

}  // namespace tia
