// What the tracer asks of a shape, once its numbers are prepared: where a line crosses its surface.
#pragma once

#include <concepts>

#include "core/math/aabb.h"
#include "core/math/ray.h"

namespace tia {

/// Line: all points origin + t * direction, t any sign. Space/units: object space, double.
/// Its direction is unit, and its origin is the line's point next to the middle of the shape's
/// bounds (to the origin of space where those are infinite), so that roots keep their digits.
using Line = Ray<double>;

/// Crossing: where a line meets a surface. `element` numbers the shape's faces, triangles, parts.
struct Crossing {
  double t = Aabb::far;
  int element = 0;
};

struct Vec2d {
  double u = 0, v = 0;
  bool operator==(const Vec2d&) const = default;
};

/// A form is a kind of shape with its numbers prepared for tracing.
///   solid      whether it has an inside; only such may be an operand of CSG
///   elements   how many elements it numbers
///   bounds     a box around it, infinite where it is
///   crossings  calls emit(t, element) for every crossing, whatever the sign of t. A solid emits in
///              ascending order and in pairs, in and out (Roth 1982), -inf and +inf included where
///              the line starts or ends inside; a line that grazes emits t twice. NaN is no
///              crossing
///   normal     unit, outward; at a point of that element
///   uv         surface coordinates, in [0,1] where the shape is bounded
///   work_of    optional: how many times a sphere's test trying a line on it costs, roughly
template <class F>
concept IsForm = requires(const F& form, const Line& line, const Vec3d& p, int element,
                          void (*emit)(double, int)) {
  { F::solid } -> std::convertible_to<bool>;
  { elements(form) } -> std::same_as<int>;
  { bounds(form) } -> std::same_as<Aabb>;
  { crossings(form, line, emit) } -> std::same_as<void>;
  { normal(form, p, element) } -> std::same_as<Vec3d>;
  { uv(form, p, element) } -> std::same_as<Vec2d>;
};

}  // namespace tia
