#include "core/motion/simulate.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "core/math/aabb.h"
#include "core/motion/bake.h"
#include "core/motion/bake_poses.h"
#include "core/motion/exact_world.h"
#include "core/motion/rigid_world.h"

namespace tia {
namespace {

// Of the size of the scene's motion, what baked poses may be off.
constexpr double rigid_tolerance = 1e-6;

// The diagonal of the box around all places of all bodies.
double size_of(const RigidWorld& world, const RigidMotion& motion) {
  Aabb box;
  for (std::size_t i = 0; i < motion.poses.size(); ++i) {
    const double radius = world.bodies[i].radius;
    const Vec3d reach{radius, radius, radius};
    for (const RigidPose& pose : motion.poses[i])
      box = around(box, Aabb{pose.center - reach, pose.center + reach});
  }
  return length(box.size());
}

/// SimulatedScene: one scene's physics, read for its solver.
class SimulatedScene {
 public:
  SimulatedScene(const Scene& scene, const Place& at, const std::stop_token& stop)
      : physics_(*scene.physics), at_(at), faults_(stop) {
    bodies_ = bodies_of(scene, at_, faults_);
    check_frames(scene);
    if (physics_.solver == PhysicsSolver::exact)
      lowered_ = exact_world(physics_, bodies_, at_, faults_);
    else lowered_ = rigid_world(physics_, bodies_, at_, faults_);
    faults_.raise();
  }

  Simulation operator()(std::size_t most_events) {
    try {
      made_.duration = physics_.duration;
      std::visit([&](const auto& lowered) { this->solve(lowered, most_events); }, lowered_);
      return std::move(made_);
    } catch (const BodiesOverlap& overlap) {
      throw overlapping(overlap);
    } catch (const TooManyEvents& many) {
      throw too_many(many.most, "events", ", which end at " + number_text(many.time) + " s");
    }
  }

 private:
  std::string place(const char* field) const { return at_.at("physics").pointer() + "/" + field; }

  // The animation that it becomes has as many frames as one may have.
  void check_frames(const Scene& scene) {
    const double fps = scene.animation ? scene.animation->fps : Animation{}.fps;
    if (physics_.duration * fps > Animation::most_frames)
      faults_.add({FaultKind::limit, place("duration"), Value(physics_.duration),
                   "at most " + number_text(Animation::most_frames) +
                       " frames, duration times the animation's fps"});
  }

  void solve(const Lowered<ExactWorld>& lowered, std::size_t most_events) {
    const Motion motion = solve_exact(lowered.world, most_events, faults_.stop());
    made_.events = motion.events;
    for (std::size_t i = 0; i < motion.paths.size(); ++i) {
      const double until = std::min(physics_.duration, bodies_.bodies[i].leaves);
      if (!motion.paths[i].empty() && motion.paths[i].front().time < until)
        bake_parabolas(bodies_.bodies[i].what, motion.paths[i], until, made_);
    }
    tell(motion.contacts, motion.energy, lowered);
  }

  void solve(const Lowered<RigidWorld>& lowered, std::size_t most_events) {
    const RigidWorld& world = lowered.world;
    if (physics_.duration * rigid_steps * static_cast<double>(world.bodies.size()) >
        static_cast<double>(most_events))
      throw too_many(most_events,
                     "steps of all bodies, " + std::to_string(rigid_steps) + " a second of each",
                     "");
    const RigidMotion motion = solve_rigid(world, faults_.stop());
    made_.events = motion.steps;
    const double tolerance = rigid_tolerance * size_of(world, motion);
    for (std::size_t i = 0; i < motion.poses.size(); ++i)
      if (!motion.poses[i].empty())
        bake_poses(bodies_.bodies[i].what, motion.poses[i], world.bodies[i].radius, tolerance,
                   made_);
    tell(motion.contacts, motion.energy, lowered);
  }

  template <class World>
  void tell(const std::vector<BodyContact>& contacts, const std::vector<BodyEnergy>& energy,
            const Lowered<World>& lowered) {
    for (const BodyContact& each : contacts)
      made_.contacts.push_back({each.time, bodies_.name_of(lowered.numbers(each.a)),
                                bodies_.name_of(lowered.numbers(each.b)), each.point, each.normal,
                                each.impulse});
    for (const BodyEnergy& each : energy)
      made_.energy.push_back({each.time, each.kinetic, each.potential});
  }

  InputError too_many(std::size_t most, const std::string& what, const std::string& more) const {
    return InputError(
        {FaultKind::limit, place("duration"), Value(physics_.duration),
         "at most " + std::to_string(most) + " " + what + " (option TIA_MAX_EVENTS)" + more});
  }

  InputError overlapping(const BodiesOverlap& overlap) const {
    const auto number = [&](std::size_t i) {
      return std::visit([&](const auto& lowered) { return lowered.numbers(i); }, lowered_);
    };
    const std::size_t a = number(overlap.a), b = number(overlap.b);
    return InputError({FaultKind::conflict, place("bodies/") + std::to_string(a) + "/object",
                       excerpt(Value(bodies_.name_of(a))),
                       "a place that nothing else has; at " + number_text(overlap.time) +
                           " s it is in " + bodies_.name_of(b)});
  }

  const Physics& physics_;
  const Place& at_;
  Faults faults_;
  SceneBodies bodies_;
  std::variant<Lowered<ExactWorld>, Lowered<RigidWorld>> lowered_;
  Simulation made_;
};

}  // namespace

Simulation simulate(const Scene& scene, std::size_t most_events, const Place& at,
                    const std::stop_token& stop) {
  return SimulatedScene(scene, at, stop)(most_events);
}

void check_physics(const Scene& scene, const Place& at, const std::stop_token& stop) {
  if (scene.physics) SimulatedScene(scene, at, stop);
}

}  // namespace tia
