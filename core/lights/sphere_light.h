// SphereLight: a luminous ball. It is seen and blocks other lights, never its own.
#pragma once

#include <optional>
#include <string_view>

#include "core/input/fields.h"
#include "core/math/vec3.h"

namespace tia {

/// SphereLight. Space/units: world space, scene units. The thesis lights with its centre alone.
struct SphereLight {
  static constexpr std::string_view type = "sphere";
  std::optional<Vec3d> position;
  double radius = 0;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("position", &SphereLight::position, Spec{.about = "the centre", .min = -1e9, .max = 1e9});
    visit("radius", &SphereLight::radius,
          Spec{.about = "the radius", .min = 0, .max = 1e9, .open_min = true, .required = true});
  }
  bool operator==(const SphereLight&) const = default;
};

}  // namespace tia
