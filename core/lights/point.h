// PointLight: light from one unseen point.
#pragma once

#include <optional>
#include <string_view>

#include "core/input/fields.h"
#include "core/math/vec3.h"

namespace tia {

/// PointLight. Space/units: world space, scene units. A key light may wait for its position.
struct PointLight {
  static constexpr std::string_view type = "point";
  std::optional<Vec3d> position;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("position", &PointLight::position,
          Spec{.about = "where the light is", .min = -1e9, .max = 1e9});
  }
  bool operator==(const PointLight&) const = default;
};

}  // namespace tia
