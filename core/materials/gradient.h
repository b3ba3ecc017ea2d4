// Gradient: a list of colours along x, repeated.
#pragma once

#include "core/materials/pattern.h"

namespace tia {

/// Gradient: x - floor(x) through the stops.
struct Gradient : Pattern {
  static constexpr std::string_view type = "gradient";
  ColorStops colors = white_to_black();

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("colors", &Gradient::colors, color_stops);
    Pattern::fields(visit);
  }
  bool operator==(const Gradient&) const = default;
};

struct GradientForm {
  PatternSpace space;
  Ramp ramp;
};

inline GradientForm prepare(const Gradient& gradient) {
  return {prepare(static_cast<const Pattern&>(gradient)), Ramp(gradient.colors)};
}

inline Vec3d color_at(const GradientForm& form, const Vec3d& p, const Vec2d&, double blur) {
  return form.ramp.at(fraction_of(form.space.point(p).x, form.space.blur(blur).x));
}

}  // namespace tia
