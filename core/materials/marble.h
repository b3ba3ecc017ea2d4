// Marble: veins perpendicular to x, distorted by turbulence.
#pragma once

#include "core/materials/pattern.h"
#include "core/math/deterministic.h"
#include "core/math/noise.h"

namespace tia {

/// Marble: (1 - cos(2 pi w)) / 2 through the stops, of w = x + turbulence * turbulence_at(x, y, z).
/// The first colour stands at integers, the last midway between them.
/// Source: K. Perlin, "An Image Synthesizer", SIGGRAPH 1985, "marble": a colour of the sine of
/// x + turbulence; here with the period 1.
struct Marble : Pattern {
  static constexpr std::string_view type = "marble";
  ColorStops colors = white_to_black();
  double turbulence = 1;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("colors", &Marble::colors, color_stops);
    visit("turbulence", &Marble::turbulence,
          Spec{.about = "how far the veins are bent, in veins; 0 leaves them straight",
               .min = 0,
               .max = 100});
    Pattern::fields(visit);
  }
  bool operator==(const Marble&) const = default;
};

struct MarbleForm {
  PatternSpace space;
  Ramp ramp;
  double turbulence = 0;
};

inline MarbleForm prepare(const Marble& marble) {
  return {prepare(static_cast<const Pattern&>(marble)), Ramp(marble.colors), marble.turbulence};
}

inline Vec3d color_at(const MarbleForm& form, const Vec3d& p, const Vec2d&, double) {
  const Vec3d q = form.space.point(p);
  const double place = q.x + form.turbulence * turbulence_at(q);
  return form.ramp.at((1 - cos_of(2 * pi * fraction_of(place, 0))) / 2);
}

}  // namespace tia
