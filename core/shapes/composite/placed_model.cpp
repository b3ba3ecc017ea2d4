#include "core/shapes/composite/placed_model.h"

#include <tuple>

#include "core/input/codec.h"

namespace tia {

void Fit::check(const Place& at, Faults& faults) const {
  if (min.x < max.x && min.y < max.y && min.z < max.z) return;
  faults.add({FaultKind::out_of_range, at.at("max").pointer(), write_value(max),
              "above min in every component"});
}

bool PlacedModel::operator==(const PlacedModel& other) const {
  const auto written = [](const PlacedModel& m) {
    return std::tie(m.id, m.scene, m.up, m.fit, m.time, m.animation, m.variant, m.hide,
                    m.point_radius, m.ambient, m.smooth, m.culling);
  };
  return written(*this) == written(other);
}

}  // namespace tia
