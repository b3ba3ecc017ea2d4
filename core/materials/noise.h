// Noise: a gradient of colours by Perlin's noise.
#pragma once

#include "core/materials/pattern.h"
#include "core/math/noise.h"

namespace tia {

/// Noise: Perlin's gradient noise, (1 + noise) / 2, through the stops.
struct Noise : Pattern {
  static constexpr std::string_view type = "noise";
  ColorStops colors = white_to_black();

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("colors", &Noise::colors, color_stops);
    Pattern::fields(visit);
  }
  bool operator==(const Noise&) const = default;
};

struct NoiseForm {
  PatternSpace space;
  Ramp ramp;
};

inline NoiseForm prepare(const Noise& noise) {
  return {prepare(static_cast<const Pattern&>(noise)), Ramp(noise.colors)};
}

inline Vec3d color_at(const NoiseForm& form, const Vec3d& p, const Vec2d&, double) {
  return form.ramp.at((1 + gradient_noise(form.space.point(p))) / 2);
}

}  // namespace tia
