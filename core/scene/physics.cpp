#include "core/scene/physics.h"

namespace tia {

void PhysicsBody::check(const Place& at, Faults& faults) const {
  if (mass.has_value() != density.has_value()) return;
  const FaultKind kind = mass ? FaultKind::conflict : FaultKind::missing;
  faults.add({kind, at.pointer(), std::nullopt, "mass or density"});
}

void PhysicsPair::check(const Place& at, Faults& faults) const {
  const Place list = at.at("objects");
  if (objects.size() > 2)
    faults.add(
        {FaultKind::out_of_range, list.pointer(), excerpt(write_value(objects)), "two objects"});
  else if (objects.size() == 2 && objects[0] == objects[1])
    faults.add({FaultKind::conflict, list.at(1).pointer(), Value(objects[1]), "another object"});
}

void Physics::check(const Place& at, Faults& faults) const {
  if (solver != PhysicsSolver::exact) return;
  for (std::size_t i = 0; i < bodies.size() && !faults.full(); ++i)
    if (bodies[i].spin != Vec3d{})
      faults.add({FaultKind::conflict, at.at("bodies").at(i).at("spin").pointer(),
                  write_value(bodies[i].spin), "none by exact, or the solver rigid"});
}

}  // namespace tia
