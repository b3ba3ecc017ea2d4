// The explicit surface: the graph of a formula of x and y.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "core/shapes/formula/isosurface.h"

namespace tia {

/// Explicit. Surface: z is the formula's value at (x, y), within the bounds; inside below it. Where
/// the formula is undefined there is nothing. Space/units: scene units, object space.
struct Explicit {
  static constexpr std::string_view type = "explicit";
  std::string z;
  Bounds bounds;
  std::map<std::string, double> parameters;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit(
        "z", &Explicit::z,
        Spec{.about = "a formula of x and y, as implicit's f is one of x, y, z", .required = true});
    visit("bounds", &Explicit::bounds,
          Spec{.about = "what the surface is clipped to", .required = true});
    visit("parameters", &Explicit::parameters,
          Spec{.about = "numbers by the names that the formula has for them",
               .min = -1e30,
               .max = 1e30});
  }
  /// A formula that cannot be read; parameters whose names it cannot say.
  void check(const Place& at, Faults& faults) const;
  bool operator==(const Explicit&) const = default;
};

IsosurfaceForm prepare(const Explicit& graph);
/// Without searching for the surface in it.
inline Aabb bounds(const Explicit& graph) { return bounds(prepare(graph.bounds)); }

}  // namespace tia
