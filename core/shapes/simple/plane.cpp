#include "core/shapes/simple/plane.h"

#include "core/input/codec.h"

namespace tia {

void Plane::check(const Place& at, Faults& faults) const {
  if (normal == Vec3d{0, 0, 0})
    faults.add({FaultKind::out_of_range, at.at("normal").pointer(), write_value(normal),
                "a direction of some length"});
}

}  // namespace tia
