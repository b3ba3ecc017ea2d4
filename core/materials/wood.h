// Wood: rings around the y axis, distorted by turbulence.
#pragma once

#include "core/materials/pattern.h"
#include "core/math/noise.h"

namespace tia {

/// Wood: the fractional part of sqrt(x^2 + z^2) + turbulence * turbulence_at(x, y, z) through the
/// stops.
/// Source: D. R. Peachey, "Solid Texturing of Complex Surfaces", SIGGRAPH 1985: concentric
/// cylinders, disturbed; here by Perlin's turbulence.
struct Wood : Pattern {
  static constexpr std::string_view type = "wood";
  ColorStops colors = white_to_black();
  double turbulence = 0.1;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("colors", &Wood::colors, color_stops);
    visit("turbulence", &Wood::turbulence,
          Spec{.about = "how far the rings are bent, in rings; 0 leaves them round",
               .min = 0,
               .max = 100});
    Pattern::fields(visit);
  }
  bool operator==(const Wood&) const = default;
};

struct WoodForm {
  PatternSpace space;
  Ramp ramp;
  double turbulence = 0;
};

inline WoodForm prepare(const Wood& wood) {
  return {prepare(static_cast<const Pattern&>(wood)), Ramp(wood.colors), wood.turbulence};
}

inline Vec3d color_at(const WoodForm& form, const Vec3d& p, const Vec2d&, double blur) {
  const Vec3d q = form.space.point(p), off = form.space.blur(blur);
  const double distance = std::sqrt(q.x * q.x + q.z * q.z);
  const double ring = distance + form.turbulence * turbulence_at(q);
  return form.ramp.at(fraction_of(ring, std::sqrt(off.x * off.x + off.z * off.z)));
}

}  // namespace tia
