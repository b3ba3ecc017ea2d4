// DirectionalLight: a light infinitely far away, whose light has the same direction everywhere.
#pragma once

#include <optional>
#include <string_view>

#include "core/input/errors.h"
#include "core/input/fields.h"
#include "core/lights/light_sample.h"
#include "core/math/onb.h"

namespace tia {

/// DirectionalLight. Space/units: world space; of any length.
struct DirectionalLight {
  static constexpr std::string_view type = "directional";
  static constexpr bool endless = true;
  std::optional<Vec3d> direction;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("direction", &DirectionalLight::direction,
          Spec{.about = "the way the light travels", .min = -1e9, .max = 1e9});
  }
  /// A direction of no length.
  void check(const Place& at, Faults& faults) const;
  bool operator==(const DirectionalLight&) const = default;

  static constexpr const char* place_field = "direction";
  bool waits() const { return !direction; }
  /// None: it is infinitely far.
  std::optional<Vec3d> place() const { return std::nullopt; }
  /// Shines from there towards the target.
  void move_to(const Vec3d& from, const Vec3d& target) { direction = target - from; }
  void move_by(const Vec3d&) {}  // its direction is the same everywhere
};

struct DirectionalForm {
  Constant wi;  ///< towards the light, unit
};
inline DirectionalForm prepare(const DirectionalLight& light) {
  return {unit(*light.direction) * -1.0};
}
template <class Real>
LightSample<Real> sample_li(const DirectionalForm& light, const Vec3<Real>&) {
  return {lift<Real>(light.wi), Real(infinity), Real(1)};
}
static_assert(LitForm<DirectionalForm>);

}  // namespace tia
