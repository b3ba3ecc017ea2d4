#include "core/lights/light.h"

#include "core/input/codec.h"

namespace tia {

void Light::check_kind(Faults& faults) const {
  std::visit(
      [&]<class Kind>(const Kind& light) {
        if constexpr (Checked<Kind>) light.check(Place{}, faults);
      },
      kind);
}

void Light::check(const Place& at, Faults& faults) const {
  const bool endless = std::visit([]<class Kind>(const Kind&) { return Kind::endless; }, kind);
  if (fade_distance && endless)
    faults.add({FaultKind::conflict, at.at("fade_distance").pointer(), Value(*fade_distance),
                "fading of a light that is at some distance"});
}

std::string_view Light::type() const {
  return std::visit([]<class Kind>(const Kind&) { return std::string_view(Kind::type); }, kind);
}

bool Light::seen() const {
  return std::visit([]<class Kind>(const Kind&) { return SeenLight<Kind>; }, kind);
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
