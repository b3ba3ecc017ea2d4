// Fog as the scene writes it.
#pragma once

#include <optional>

#include "core/input/fields.h"
#include "core/input/value_codecs.h"
#include "core/shapes/bounds.h"

namespace tia {

/// Fog: what fills the space outside of glass, everywhere alike, and scatters light on its way: on
/// average once in a length of 1 / density. Integrators other than path look through it.
/// Space/units: world space, scene units.
struct Fog {
  static constexpr std::string_view schema_name = "fog";
  double density = 0;
  Color albedo{1, 1, 1};
  double g = 0;
  std::optional<Bounds> bounds{};

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit(
        "density", &Fog::density,
        Spec{.about = "how often light is met by it in a scene unit; of what shines at a distance "
                      "d, e^(-density d) comes straight",
             .min = 0,
             .max = 1e6,
             .required = true});
    visit("albedo", &Fog::albedo,
          Spec{.about = "linear RGB of the share of that which is scattered; the rest is absorbed",
               .min = 0,
               .max = 1});
    visit("g", &Fog::g,
          Spec{.about = "the mean cosine of the angle by which light turns: 0 to all sides alike, "
                        "towards 1 ahead, towards -1 back",
               .min = -0.999,
               .max = 0.999});
    visit("bounds", &Fog::bounds,
          Spec{.about = "what it fills; else all space, and nothing infinitely far is seen through "
                        "it or lights it"});
  }
  bool operator==(const Fog&) const = default;
};

}  // namespace tia
