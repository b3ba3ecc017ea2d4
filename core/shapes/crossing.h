// What the tracer asks of a shape, once its numbers are prepared: where a line crosses its surface.
#pragma once

#include <concepts>
#include <cstdint>
#include <string_view>

#include "core/math/aabb.h"
#include "core/math/heap.h"
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

/// FirstCrossing: the first one found, its t infinite where there is none, and what finding it cost
/// beyond the form's work_of. Space/units: work in tests of a sphere.
struct FirstCrossing {
  Crossing at;
  std::int64_t work = 0;
};

/// Bracket: the stretch of a line in which exactly this root lies, and what says so; a point where
/// no search was needed. It explains a crossing, and nothing is computed from it.
struct Bracket {
  double from = 0, to = 0;
  std::string_view how;  ///< of static storage
  int degree = 0;        ///< of the polynomial along the line; 0 where there is none
};

/// What crossings are emitted to may take their brackets as well.
template <class Emit>
concept TakesBracket = std::invocable<Emit&, double, int, const Bracket&>;

/// Calls emit(t, element, bracket) where emit takes a bracket, else emit(t, element).
template <class Emit>
void emit_root(Emit& emit, double t, int element, const Bracket& bracket) {
  if constexpr (TakesBracket<Emit>) emit(t, element, bracket);
  else emit(t, element);
}

struct Vec2d {
  double u = 0, v = 0;
  bool operator==(const Vec2d&) const = default;
};

/// What a function may return that counts its work, or does not.
template <class Returned>
concept IsWork = std::same_as<Returned, void> || std::same_as<Returned, std::int64_t>;

/// A form is a kind of shape with its numbers prepared for tracing.
///   solid      whether it has an inside; only such may be an operand of CSG
///   elements   how many elements it numbers
///   bounds     a box around it, infinite where it is
///   crossings  calls emit(t, element) for every crossing, whatever the sign of t. A solid emits in
///              ascending order and in pairs, in and out (Roth 1982), -inf and +inf included where
///              the line starts or ends inside; a line that grazes emits t twice. NaN is no
///              crossing. Of a root that was searched for it may call emit_root
///   normal     unit, outward; at a point of that element
///   uv         surface coordinates, in [0,1] where the shape is bounded
///   heap_bytes what it owns on the heap; there is one for all forms that own nothing
/// What it may have besides is below and in eight_lines.h, a concept each: a form's own file
/// asserts those that it has, lest one of the wrong signature be passed over.
/// What a line costs is hardly known before where it is searched step by step: so crossings and
/// spans may return the work beyond work_of that they did, as first_crossing does.
template <class F>
concept IsForm = requires(const F& form, const Line& line, const Vec3d& p, int element,
                          void (*emit)(double, int)) {
  { F::solid } -> std::convertible_to<bool>;
  { elements(form) } -> std::same_as<int>;
  { bounds(form) } -> std::same_as<Aabb>;
  { crossings(form, line, emit) } -> IsWork;
  { normal(form, p, element) } -> std::same_as<Vec3d>;
  { uv(form, p, element) } -> std::same_as<Vec2d>;
  { heap_bytes(form) } -> std::same_as<std::size_t>;
};

/// Optional, work_of: how many times a sphere's test trying a line on it costs, roughly.
template <class F>
concept TellsWork = requires(const F& form) {
  { work_of(form) } -> std::same_as<int>;
};
/// Optional, material_number, where an object has numbered materials: which of them an element
/// wears, 0 the object's own.
template <class F>
concept NumbersMaterials = requires(const F& form, int element) {
  { material_number(form, element) } -> std::same_as<int>;
};
/// Optional, spans: as crossings, of a solid whose surface is open where bounds cut it.
template <class F>
concept HasSpans = requires(const F& form, const Line& line, void (*emit)(double, int)) {
  { spans(form, line, emit) } -> IsWork;
};
/// Optional, first_crossing(form, line, after, before), where the first crossing with
/// after < t < before is found with less than all. Its t and element are the same to the bit
/// whatever `before` is, and those that crossings emits, whose t a search from `after` on may round
/// otherwise; a line that has NaN has none.
template <class F>
concept FindsFirstCrossing = requires(const F& form, const Line& line, double t) {
  { first_crossing(form, line, t, t) } -> std::same_as<FirstCrossing>;
};
/// Optional, light_center: a luminous one lights others from that point of its own space. Without
/// it, it is seen and lights nothing.
template <class F>
concept LightsFromCenter = requires(const F& form) {
  { light_center(form) } -> std::same_as<Vec3d>;
};
/// Optional, of a description: bounds(), where they are told with less than its form.
template <class S>
concept TellsBounds = requires(const S& shape) {
  { bounds(shape) } -> std::same_as<Aabb>;
};

}  // namespace tia
