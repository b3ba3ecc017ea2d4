#include "core/lights/spot.h"

#include "core/input/codec.h"
#include "core/input/json.h"

namespace tia {

void SpotLight::check(const Place& at, Faults& faults) const {
  if (falloff_degrees < radius_degrees)
    faults.add({FaultKind::out_of_range, at.at("falloff_degrees").pointer(), Value(falloff_degrees),
                "a number from radius_degrees, " + number_text(radius_degrees) + ", to 180"});
  if (position == point_at)
    faults.add({FaultKind::out_of_range, at.at("point_at").pointer(), write_value(point_at),
                "a point other than position"});
}

}  // namespace tia
