// The implicit surface: where a formula of x, y and z is 0.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "core/shapes/formula/isosurface.h"

namespace tia {

/// Implicit. Surface: f = 0 within the bounds; inside where f < 0. Where f is undefined there is
/// nothing. Space/units: scene units, object space; angles in radians.
struct Implicit {
  static constexpr std::string_view type = "implicit";
  std::string f;
  Bounds bounds;
  std::map<std::string, double> parameters;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit(
        "f", &Implicit::f,
        Spec{.about = "a formula of x, y, z: numbers, + - * / ^, parentheses, pi, sqrt abs min max "
                      "floor exp log sin cos tan asin acos atan atan2 sinh cosh tanh, parameters; "
                      "the surface is where it is 0, the inside where it is below",
             .required = true});
    visit("bounds", &Implicit::bounds,
          Spec{.about = "what the surface is clipped to", .required = true});
    visit("parameters", &Implicit::parameters,
          Spec{.about = "numbers by the names that the formula has for them",
               .min = -1e30,
               .max = 1e30});
  }
  /// A formula that cannot be read; parameters whose names it cannot say.
  void check(const Place& at, Faults& faults) const;
  bool operator==(const Implicit&) const = default;
};

IsosurfaceForm prepare(const Implicit& implicit);
/// Without searching for the surface in it.
inline Aabb bounds(const Implicit& implicit) { return bounds(prepare(implicit.bounds)); }

}  // namespace tia
