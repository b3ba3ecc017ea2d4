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

}  // namespace

std::size_t LoweredRigid::number_of(std::size_t in_world) const {
  const std::size_t bodies = world.bodies.size();
  return in_world < bodies ? in_world : bodies + row_of_fixed[in_world - bodies];
}

LoweredRigid rigid_world(const Physics& physics, const SceneBodies& bodies, const Place& at,
                         Faults& faults) {
  const Place physics_at = at.at("physics");
  const Place all_bodies = physics_at.at("bodies"), all_fixed = physics_at.at("fixed");
  LoweredRigid lowered;
  RigidWorld& world = lowered.world;
  world.gravity = physics.gravity;
  world.duration = physics.duration;
  for (std::size_t i = 0; i < bodies.bodies.size() && !faults.full(); ++i)
    world.bodies.push_back(rigid_body(bodies.bodies[i], all_bodies.at(i), faults));
  for (std::size_t i = 0; i < bodies.fixed.size() && !faults.full(); ++i) {
    const FixedBody& fixed = bodies.fixed[i];
    if (fixed.what.object != nullptr &&
        !add_fixed_parts(*fixed.what.object, fixed.what.parent, world.fixed))
      faults.add({FaultKind::conflict, all_fixed.at(i).at("object").pointer(),
                  Value(fixed.said->object),
                  "by rigid a plane, sphere, box, cylinder, cone, capsule, triangle, mesh or a "
                  "group of them; what is round scaled alike on every axis"});
    lowered.row_of_fixed.resize(world.fixed.size(), i);
  }
  const auto numbers = [rows = lowered.row_of_fixed, count = world.bodies.size()](std::size_t i) {
    return i < count ? i : count + rows[i - count];
  };
  world.restitution = [&bodies, numbers](std::size_t a, std::size_t b) {
    return bodies.restitution(numbers(a), numbers(b));
  };
  world.friction = [&bodies, numbers](std::size_t a, std::size_t b) {
    return bodies.friction(numbers(a), numbers(b));
  };
  return lowered;
}

}  // namespace tia
