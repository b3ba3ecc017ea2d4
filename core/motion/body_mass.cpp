#include "core/motion/body_mass.h"

#include <cmath>

#include "core/motion/measure.h"

namespace tia {

double mass_of(const MovingBody& body, const Place& at, Faults& faults) {
  if (body.said->mass) return *body.said->mass;
  const auto measure = measure_of(body.what.object->shape);
  if (measure)
    return *body.said->density * measure->volume * std::abs(body.what.place().determinant());
  faults.add({FaultKind::conflict, at.at("density").pointer(), Value(*body.said->density),
              "of a " + measured_shapes() + "; else mass"});
  return 1;
}

}  // namespace tia
