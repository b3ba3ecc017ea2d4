// THE LIST of lights. A new kind is one file beside this one and one entry here.
#pragma once

#include <variant>

#include "core/lights/point.h"
#include "core/lights/sphere_light.h"

namespace tia {

/// Light: a kind and what all kinds share. It sends color * intensity.
struct Light {
  std::variant<PointLight, SphereLight> kind;
  Color color{1, 1, 1};
  double intensity = 1;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit.one_of(&Light::kind, Spec{.about = "the kind of light", .required = true});
    visit("color", &Light::color, Spec{.about = "linear RGB", .max = 1e6});
    visit("intensity", &Light::intensity,
          Spec{.about = "factor on the colour", .min = 0, .max = 1e6});
  }
  bool operator==(const Light&) const = default;

  const std::optional<Vec3d>& position() const {
    return std::visit(
        [](const auto& light) -> const auto& { return light.position; }, kind);
  }
  void move_to(const Vec3d& position) {
    std::visit([&](auto& light) { light.position = position; }, kind);
  }
};

}  // namespace tia
