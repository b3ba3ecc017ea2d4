// The checker: cells of two colours in all three directions.
#pragma once

#include "core/materials/pattern.h"

namespace tia {

/// Checker: the first colour where floor(x) + floor(y) + floor(z) is even, else the second.
struct Checker : Pattern {
  static constexpr std::string_view type = "checker";
  TwoColors colors = black_on_white;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("colors", &Checker::colors, two_colors);
    Pattern::fields(visit);
  }
  bool operator==(const Checker&) const = default;
};

struct CheckerForm {
  PatternSpace space;
  std::array<Vec3d, 2> colors;
};

inline CheckerForm prepare(const Checker& checker) {
  const auto& [even, odd] = checker.colors;
  return {prepare(static_cast<const Pattern&>(checker)), {rgb_of(even), rgb_of(odd)}};
}

/// Whether an integer of any size is odd. Infinities and NaN count as odd.
inline bool is_odd(double integer) { return integer - 2 * std::floor(integer / 2) != 0; }

inline Vec3d color_at(const CheckerForm& form, const Vec3d& p, const Vec2d&, double blur) {
  const Vec3d q = form.space.point(p), off = form.space.blur(blur);
  // Not of the sum, which would be rounded far from the origin.
  const bool odd = is_odd(floor_of(q.x, off.x)) !=
                   (is_odd(floor_of(q.y, off.y)) != is_odd(floor_of(q.z, off.z)));
  return form.colors[odd ? 1 : 0];
}

}  // namespace tia
