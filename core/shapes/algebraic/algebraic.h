// The algebraic surface: a polynomial in x, y and z of any degree up to 64, alone or clipped to
// bounds. Its crossings are the roots of the polynomial along the line.
#pragma once

#include <optional>
#include <string_view>

#include "core/shapes/algebraic/nested_polynomial.h"
#include "core/shapes/bounds.h"
#include "core/shapes/eight_lines.h"
#include "core/shapes/roots_along.h"

namespace tia {

/// Algebraic. Surface: the sum of the terms is 0; inside where it is below 0. Bounds cut the
/// surface open; as a solid it is closed by them. Terms of like powers add up.
/// Space/units: scene units, object space. The sum's digits are those around the origin: the
/// farther from it, the fewer are left, the sooner the higher the degree.
struct Algebraic {
  static constexpr std::string_view type = "algebraic";
  std::vector<AlgebraicTerm> terms;
  std::optional<Bounds> bounds;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("terms", &Algebraic::terms,
          Spec{.about = "[i, j, k, c] for c x^i y^j z^k, i + j + k at most 64; inside where the "
                        "sum is below 0",
               .min = -1e30,
               .max = 1e30,
               .required = true,
               .min_items = 1});
    visit("bounds", &Algebraic::bounds, Spec{.about = "what the surface is clipped to"});
  }
  /// Terms of too high a degree; nothing but a constant.
  void check(const Place& at, Faults& faults) const;
  bool operator==(const Algebraic&) const = default;
};

/// AlgebraicForm. Its elements: 0 the surface itself, 1 and up the bounds'.
struct AlgebraicForm {
  static constexpr bool solid = true;
  NestedPolynomial polynomial;
  std::optional<Region> region;
  /// What is proven to hold the whole solid where nothing bounds it.
  std::optional<Region> reach;

  /// Where first crossings are sought; nowhere in particular: no such place.
  const std::optional<Region>& searched() const { return region ? region : reach; }
};

AlgebraicForm prepare(const Algebraic& algebraic);
inline std::size_t heap_bytes(const AlgebraicForm& a) { return a.polynomial.heap(); }
/// The terms are summed up once a line; isolating the roots goes with the square of the degree.
inline int work_of(const AlgebraicForm& a) {
  return 16 + static_cast<int>(a.polynomial.size()) + a.polynomial.degree() * a.polynomial.degree();
}
inline int elements(const AlgebraicForm& a) { return 1 + (a.region ? elements(*a.region) : 0); }
inline Aabb bounds(const AlgebraicForm& a) {
  return a.searched() ? bounds(*a.searched()) : Aabb::everything();
}

/// AlgebraicRoots: where a line changes sides within the bounds, ascending, and the side on which
/// it starts. A touching root stands twice. The lists hold `count` entries, the others nothing.
struct AlgebraicRoots {
  Chord within;  ///< the line's stretch within the bounds, all of it where there are none
  bool starts_inside = false;
  int count = 0, degree = 0;
  std::array<double, most_algebraic_degree> t;
  std::array<RootBracket, most_algebraic_degree> brackets;

  bool ends_inside() const { return starts_inside != (count % 2 == 1); }
  /// Calls f for every root and both ends of its bracket.
  template <class F>
  void for_each_t(F f) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
      for (double* each : {&t[i], &brackets[i].low, &brackets[i].high}) f(*each);
  }
  template <class Emit>
  void emit_all(Emit& emit) const {
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
      emit_root(emit, t[i], 0, explained(brackets[i], degree));
  }
};
AlgebraicRoots roots(const AlgebraicForm& algebraic, const Line& line);

/// The crossings of the solid: what is inside the surface and the bounds, closed by these.
template <class Emit>
void spans(const AlgebraicForm& algebraic, const Line& line, Emit&& emit) {
  const AlgebraicRoots found = roots(algebraic, line);
  if (found.starts_inside) emit(found.within.in.t, found.within.in.element);
  found.emit_all(emit);
  if (found.ends_inside()) emit(found.within.out.t, found.within.out.element);
}

/// The surface's crossings, those within the bounds. Where there are bounds they make no pairs:
/// CSG wants spans.
template <class Emit>
void crossings(const AlgebraicForm& algebraic, const Line& line, Emit&& emit) {
  if (!algebraic.region) return spans(algebraic, line, emit);
  roots(algebraic, line).emit_all(emit);
}
/// The first of eight lines each, by Bernstein's form of the polynomial on their stretches.
EightCrossings first_crossings(const AlgebraicForm& algebraic, const EightLines& eight);
inline FirstCrossing first_crossing(const AlgebraicForm& algebraic, const Line& line, double after,
                                    double before) {
  return first_crossings(algebraic, EightLines::one(line, after, before)).one();
}

/// The gradient's direction; where it is 0, at a singular point, or too great for a double: +y.
Vec3d normal(const AlgebraicForm& algebraic, const Vec3d& p, int element);
Vec3<Octet> normals(const AlgebraicForm& algebraic, const Vec3<Octet>& p);
/// Returns: longitude and latitude, as a sphere has them, around the middle of the bounds (the
/// origin if there are none); on the bounds' faces theirs.
Vec2d uv(const AlgebraicForm& algebraic, const Vec3d& p, int element);

static_assert(IsForm<AlgebraicForm>);
static_assert(TellsWork<AlgebraicForm>);
static_assert(HasSpans<AlgebraicForm>);
static_assert(FindsFirstCrossing<AlgebraicForm>);
static_assert(FindsEightFirstCrossings<AlgebraicForm>);
static_assert(HasEightNormals<AlgebraicForm>);

}  // namespace tia
