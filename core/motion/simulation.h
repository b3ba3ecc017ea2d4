// Simulation: what came of a scene's physics, kept: tracks in the place of bodies, so that a moment
// needs no solver.
#pragma once

#include <string>
#include <vector>

#include "core/scene/animation_target.h"
#include "core/scene/scene.h"

namespace tia {

/// MotionSteps: what a body's object has at the end of its transform, as it is at the time 0.
struct MotionSteps {
  TargetPath object;
  std::vector<TransformSteps::Step> steps;
};

/// NamedContact: two that meet, as answers call them. The normal runs from b to a.
struct NamedContact {
  double time = 0;
  std::string a, b;
  Vec3d point{}, normal{};
  double impulse = 0;
};
/// MotionEnergy: of all bodies together; potential = -m g.x, from the scene's origin.
struct MotionEnergy {
  double time = 0, kinetic = 0, potential = 0;
};

struct Simulation {
  static constexpr std::size_t most_listed = 100'000;  ///< contacts, and energies
  double duration = 0;
  std::vector<Track> tracks;
  std::vector<MotionSteps> steps;
  std::vector<NamedContact> contacts;  ///< the first ones
  std::vector<MotionEnergy> energy;    ///< evenly thinned out
  std::size_t events = 0;
};

/// The scene in which tracks are in the place of its physics: steps at the end of its bodies'
/// transforms, and an animation as long as both its own and the motion.
/// Domain: the simulation is of that scene, whatever its lights, camera and materials.
Scene with_motion(const Scene& scene, const Simulation& simulation);

/// Space/units: bytes that it takes, about.
std::size_t bytes_of(const Simulation& simulation);

/// {"scene", "contacts", "energy", "events"}: what it is as JSON, the scene with its tracks.
Value simulation_json(const Scene& scene, const Simulation& simulation);
/// Its JSON Schema, the scene's given.
Value simulation_schema(const Value& scene, Definitions& named);

}  // namespace tia
