// PointLight: a point that shines in all directions and cannot be seen.
#pragma once

#include <optional>
#include <string_view>

#include "core/input/fields.h"
#include "core/lights/light_sample.h"

namespace tia {

/// PointLight. Space/units: world space, scene units. A key light may wait for its position.
struct PointLight {
  static constexpr std::string_view type = "point";
  static constexpr bool endless = false;
  std::optional<Vec3d> position;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("position", &PointLight::position,
          Spec{.about = "where the light is", .min = -1e9, .max = 1e9});
  }
  bool operator==(const PointLight&) const = default;

  static constexpr const char* place_field = "position";
  bool waits() const { return !position; }
  std::optional<Vec3d> place() const { return position; }
  void move_to(const Vec3d& to, const Vec3d&) { position = to; }
  void move_by(const Vec3d& way) { position = *position + way; }
};

struct PointForm {
  Constant middle;
};
inline PointForm prepare(const PointLight& light) { return {*light.position}; }
static_assert(ShinesFromPoint<PointForm>);

}  // namespace tia
