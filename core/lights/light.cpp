#include "core/lights/light.h"

#include "core/input/codec.h"
#include "core/input/json.h"

namespace tia {

void DirectionalLight::check(const Place& at, Faults& faults) const {
  if (direction == Vec3d{0, 0, 0})
    faults.add({FaultKind::out_of_range, at.at("direction").pointer(), write_value(*direction),
                "a direction of some length"});
}

void SpotLight::check(const Place& at, Faults& faults) const {
  if (falloff_degrees < radius_degrees)
    faults.add({FaultKind::out_of_range, at.at("falloff_degrees").pointer(), Value(falloff_degrees),
                "a number from radius_degrees, " + number_text(radius_degrees) + ", to 180"});
  if (position == point_at)
    faults.add({FaultKind::out_of_range, at.at("point_at").pointer(), write_value(point_at),
                "a point other than position"});
}

void QuadLight::check(const Place& at, Faults& faults) const {
  const Vec3d across = cross(u, v);
  if (length(across) > 1e-12 * length(u) * length(v)) return;
  const bool no_u = u == Vec3d{0, 0, 0};
  faults.add({FaultKind::out_of_range, at.at(no_u ? "u" : "v").pointer(), write_value(no_u ? u : v),
              std::string("an edge that spans an area with ") + (no_u ? "v" : "u")});
}

void Light::check_kind(Faults& faults) const {
  std::visit(
      [&](const auto& light) {
        if constexpr (requires { light.check(Place{}, faults); }) light.check(Place{}, faults);
      },
      kind);
}

void Light::check(const Place& at, Faults& faults) const {
  const bool endless =
      std::holds_alternative<DirectionalLight>(kind) || std::holds_alternative<SkyLight>(kind);
  if (fade_distance && endless)
    faults.add({FaultKind::conflict, at.at("fade_distance").pointer(), Value(*fade_distance),
                "fading of a light that is at some distance"});
}

bool Light::movable() const {
  return std::visit([]<class Kind>(const Kind&) { return MovableLight<Kind>; }, kind);
}

const char* Light::awaited() const {
  return std::visit(
      []<class Kind>(const Kind& light) -> const char* {
        if constexpr (MovableLight<Kind>) return light.waits() ? Kind::place_field : nullptr;
        else return nullptr;
      },
      kind);
}

std::optional<Vec3d> Light::place() const {
  return std::visit(
      []<class Kind>(const Kind& light) -> std::optional<Vec3d> {
        if constexpr (MovableLight<Kind>) return light.place();
        else return std::nullopt;
      },
      kind);
}

void Light::move_to(const Vec3d& to, const Vec3d& target) {
  std::visit(
      [&]<class Kind>(Kind& light) {
        if constexpr (MovableLight<Kind>) light.move_to(to, target);
      },
      kind);
}

}  // namespace tia
