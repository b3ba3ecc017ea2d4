#include "core/lights/directional.h"

#include "core/input/codec.h"

namespace tia {

void DirectionalLight::check(const Place& at, Faults& faults) const {
  if (direction == Vec3d{0, 0, 0})
    faults.add({FaultKind::out_of_range, at.at("direction").pointer(), write_value(*direction),
                "a direction of some length"});
}

}  // namespace tia
