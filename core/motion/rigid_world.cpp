#include "core/motion/rigid_world.h"

#include "core/motion/body_mass.h"
#include "core/motion/rigid_part.h"

namespace tia {
namespace {

RigidBody rigid_body(const MovingBody& body, const Place& at, Faults& faults) {
  RigidBody made;
  made.velocity = body.said->velocity;
  made.spin = body.said->spin;
  made.enters = body.enters;
  made.leaves = body.leaves;
  if (body.what.object == nullptr) return made;  // a fault says so already
  const std::size_t known = faults.count();
  made.mass = mass_of(body, at, faults);
  if (faults.count() > known) return made;
  const auto part = moving_part(body.what.object->shape, body.what.place(), made.mass);
  if (!part) {
    faults.add({FaultKind::conflict, at.at("object").pointer(), Value(body.said->object),
                "by rigid a sphere, box, cylinder, cone, capsule or a mesh that is closed; what is "
                "round scaled alike on every axis"});
    return made;
  }
  made.part = part->part;
  made.frame = part->inertia.frame;
  made.moments = part->inertia.moments;
  made.radius = part->radius;
  return made;
}

constexpr const char* known_to_rigid =
    "by rigid a plane, sphere, box, cylinder, cone, capsule, triangle, mesh, walls or a group of "
    "them; what is round scaled alike on every axis";

}  // namespace

Lowered<RigidWorld> rigid_world(const Physics& physics, const SceneBodies& bodies, const Place& at,
                                Faults& faults) {
  const auto add_body = [&](const MovingBody& body, const Place& where, RigidWorld& world) {
    world.bodies.push_back(rigid_body(body, where, faults));
  };
  auto made =
      lowered<RigidWorld>(physics, bodies, at, faults, add_body, add_fixed_parts, known_to_rigid);
  made.world.friction = [&bodies, numbers = made.numbers](std::size_t a, std::size_t b) {
    return bodies.friction(numbers(a), numbers(b));
  };
  return made;
}

}  // namespace tia
