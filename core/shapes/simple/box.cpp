#include "core/shapes/simple/box.h"

#include "core/input/codec.h"

namespace tia {

void Box::check(const Place& at, Faults& faults) const {
  if (!(min.x < max.x && min.y < max.y && min.z < max.z))
    faults.add({FaultKind::out_of_range, at.at("max").pointer(), write_value(max),
                "above min in every component"});
}

}  // namespace tia
