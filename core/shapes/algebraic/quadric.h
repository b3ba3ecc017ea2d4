// The quadric: any surface of the second degree, alone or clipped to bounds.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "core/shapes/bounds.h"

namespace tia {

/// Quadric. Surface: the sum of coefficients times x2 y2 z2 xy xz yz x y z 1 is 0; inside where it
/// is below 0. Bounds cut the surface open; as a solid it is closed by them.
/// Space/units: scene units, object space.
struct Quadric {
  static constexpr std::string_view type = "quadric";
  std::array<double, 10> coefficients{};
  std::optional<Bounds> bounds;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("coefficients", &Quadric::coefficients,
          Spec{.about = "of x2 y2 z2 xy xz yz x y z 1; inside where the sum is below 0",
               .min = -1e30,
               .max = 1e30,
               .required = true});
    visit("bounds", &Quadric::bounds, Spec{.about = "what the surface is clipped to"});
  }
  void check(const Place& at, Faults& faults) const;
  bool operator==(const Quadric&) const = default;
};

/// QuadricForm. Its elements: 0 the quadric itself, 1 and up the bounds'.
struct QuadricForm {
  static constexpr bool solid = true;
  std::array<double, 10> coefficients{};
  std::optional<Region> region;
};

/// The coefficients come out scaled by a power of two, the largest near 1: their squares must not
/// vanish or overflow.
QuadricForm prepare(const Quadric& quadric);
inline int elements(const QuadricForm& q) { return 1 + (q.region ? elements(*q.region) : 0); }
inline Aabb bounds(const QuadricForm& q) {
  return q.region ? bounds(*q.region) : Aabb::everything();
}

/// QuadricSpans: the up to two stretches of a line where the whole quadric is below 0.
struct QuadricSpans {
  int count = 0;
  std::array<double, 4> ends{};  ///< in, out, in, out; ascending
};
inline Bracket in_closed_form(double t) { return {t, t, "closed form: a quadratic's root", 2}; }
QuadricSpans spans_of(const QuadricForm& quadric, const Line& line);

/// The surface's crossings, those within the bounds. Where there are bounds they make no pairs:
/// CSG wants spans.
template <class Emit>
void crossings(const QuadricForm& quadric, const Line& line, Emit&& emit) {
  const Chord within = chord(quadric.region, line);
  const QuadricSpans spans = spans_of(quadric, line);
  for (int i = 0; i < 2 * spans.count; ++i) {
    const double t = spans.ends[static_cast<std::size_t>(i)];
    if (within.in.t <= t && t <= within.out.t) emit_root(emit, t, 0, in_closed_form(t));
  }
}

/// The crossings of the solid: what is inside the quadric and the bounds, closed by these.
template <class Emit>
void spans(const QuadricForm& quadric, const Line& line, Emit&& emit) {
  const Chord within = chord(quadric.region, line);
  const QuadricSpans inside = spans_of(quadric, line);
  const auto ends = 2 * static_cast<std::size_t>(inside.count);
  for (std::size_t i = 0; i < ends; i += 2) {
    Chord both{{inside.ends[i], 0}, {inside.ends[i + 1], 0}};
    if (within.in.t > both.in.t) both.in = within.in;
    if (within.out.t < both.out.t) both.out = within.out;
    if (both.empty()) continue;
    for (const auto& [t, element] : {both.in, both.out}) {
      if (element == 0) emit_root(emit, t, element, in_closed_form(t));
      else emit(t, element);
    }
  }
}

/// At a singular point, a cone's tip, where there is none: +y.
Vec3d normal(const QuadricForm& quadric, const Vec3d& p, int element);
/// Returns: longitude and latitude, as a sphere has them, around the middle of the bounds (the
/// origin if there are none); on the bounds' faces theirs.
Vec2d uv(const QuadricForm& quadric, const Vec3d& p, int element);

static_assert(IsForm<QuadricForm>);
static_assert(HasSpans<QuadricForm>);

}  // namespace tia
