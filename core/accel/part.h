// Part: a surface with one material, in its place; what all kinds of shapes become for the tracer.
#pragma once

#include <variant>

#include "core/math/transform.h"
#include "core/shapes/shape.h"

namespace tia {

/// Part. Space/units: `to_object` leads from the space that the part stands in to its own.
struct Part {
  Form form;  ///< for a mesh part, of no meaning
  Affine to_object{};
  Vec3d middle{};         ///< of its bounds in its own space; 0 where they are infinite
  int mesh = -1;          ///< the geometry's mesh that it is instead of a form; -1: none
  int ball = -1;          ///< the geometry's ball that it is as well; -1: none
  int flat = -1;          ///< the geometry's flat that it is as well; -1: none
  int matter = 0;         ///< the geometry's matter that it wears
  int object = 0;         ///< the object that it belongs to, counted from 0 in the scene's order
  int space = 0;          ///< the space of the geometry that it stands in
  bool inverted = false;  ///< whether it cuts a solid, whose outside is then its inside
  bool placed = false;    ///< whether to_object does anything
  int work = 1;           ///< what trying a ray on it costs (Effort)
};

namespace detail {

/// Calls f(form, line, shift, length): the line as the form wants it, whose parameter s is the
/// given line's t = (s + shift) / length.
template <class F>
void with_own_line(const Part& part, const Line& line, F f) {
  const Vec3d origin = part.to_object.point(line.origin);
  const Vec3d way = part.to_object.vector(line.direction);
  const double length = tia::length(way);
  const Vec3d unit = way * (1 / length);
  const double shift = dot(part.middle - origin, unit);
  const Line own{origin + unit * shift, unit};
  std::visit([&](const auto& form) { f(form, own, shift, length); }, part.form);
}

}  // namespace detail

/// Calls emit(t, element) for each crossing of the line with the part's surface.
/// Domain: a part that is no mesh; a line of any direction but 0.
template <class Emit>
void crossings(const Part& part, const Line& line, Emit emit) {
  detail::with_own_line(part, line, [&](const auto& form, const Line& own, double shift, double n) {
    crossings(form, own, [&](double s, int element) { emit((s + shift) / n, element); });
  });
}

/// Calls emit(t, element) where the line enters and leaves the part as a solid, in pairs.
/// Domain: a part whose form is solid.
template <class Emit>
void spans(const Part& part, const Line& line, Emit emit) {
  detail::with_own_line(part, line, [&](const auto& form, const Line& own, double shift, double n) {
    const auto out = [&](double s, int element) { emit((s + shift) / n, element); };
    if constexpr (requires { spans(form, own, out); }) spans(form, own, out);
    else crossings(form, own, out);
  });
}

/// The part's first crossing with t > 0.
inline Crossing nearest_crossing(const Part& part, const Line& line) {
  Crossing nearest;
  crossings(part, line, [&](double t, int element) {
    if (t > 0 && t < nearest.t) nearest = {t, element};
  });
  return nearest;
}

}  // namespace tia
