// Stripes: layers of two colours along x.
#pragma once

#include "core/materials/checker.h"

namespace tia {

/// Stripes: the first colour where floor(x) is even, else the second.
struct Stripes : Pattern {
  static constexpr std::string_view type = "stripes";
  TwoColors colors = black_on_white;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("colors", &Stripes::colors, two_colors);
    Pattern::fields(visit);
  }
  bool operator==(const Stripes&) const = default;
};

struct StripesForm {
  PatternSpace space;
  std::array<Vec3d, 2> colors;
};

inline StripesForm prepare(const Stripes& stripes) {
  const auto& [even, odd] = stripes.colors;
  return {prepare(static_cast<const Pattern&>(stripes)), {rgb_of(even), rgb_of(odd)}};
}

inline Vec3d color_at(const StripesForm& form, const Vec3d& p, const Vec2d&, double blur) {
  const double layer = floor_of(form.space.point(p).x, form.space.blur(blur).x);
  return form.colors[is_odd(layer) ? 1 : 0];
}

}  // namespace tia
