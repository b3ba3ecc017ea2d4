// What the tests of formulas' surfaces share: the short way from a text to a form, and from a line
// to what it meets.
#pragma once

#include "core/shapes/explicit.h"
#include "core/shapes/implicit.h"
#include "tests/core/shapes/lines.h"

namespace tia::test {

using Parameters = std::map<std::string, double>;

inline Bounds box_of(const Vec3d& min, const Vec3d& max) {
  Bounds b;
  b.min = min, b.max = max;
  return b;
}
inline Bounds cube_of(double half, const Vec3d& center = {0, 0, 0}) {
  return box_of(center - Vec3d{half, half, half}, center + Vec3d{half, half, half});
}
inline Bounds ball_of(double radius, const Vec3d& center = {0, 0, 0}) {
  Bounds b;
  b.center = center, b.radius = radius;
  return b;
}

inline FieldForm implicit(const std::string& f, const Bounds& bounds,
                          const Parameters& parameters = {}) {
  return prepare(Implicit{f, bounds, parameters});
}

template <class Form>
std::vector<Crossing> spans_along(const Form& form, const SceneLine& line) {
  return sent(bounds(form), line, [&](const Line& l, auto emit) { spans(form, l, emit); });
}
inline std::vector<double> ends_of(const std::vector<Crossing>& all) {
  std::vector<double> t;
  for (const Crossing& each : all) t.push_back(each.t);
  return t;
}
/// What of t is inside a box or a ball around the line, ascending.
inline std::vector<double> clipped(std::vector<double> t, double from, double to) {
  std::sort(t.begin(), t.end());
  std::erase_if(t, [&](double each) { return each < from || each > to; });
  return t;
}

}  // namespace tia::test
