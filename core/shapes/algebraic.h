// The algebraic surface: a polynomial in x, y and z of any degree up to 32, alone or clipped to
// bounds. Its crossings are the roots of the polynomial along the line.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "core/input/codec.h"
#include "core/shapes/bounds.h"

namespace tia {

/// The highest total degree i + j + k of a term.
inline constexpr int most_algebraic_degree = 32;

/// AlgebraicTerm: coefficient * x^i y^j z^k. In JSON [i, j, k, coefficient].
struct AlgebraicTerm {
  std::array<int, 3> powers{};
  double coefficient = 0;

  int degree() const { return powers[0] + powers[1] + powers[2]; }
  bool operator==(const AlgebraicTerm&) const = default;
};

template <>
struct Codec<AlgebraicTerm> {
  static constexpr Spec power{.about = "a power", .min = 0, .max = most_algebraic_degree};
  static void read(const Value& v, const Place& at, const Spec& spec, Faults& faults,
                   AlgebraicTerm& out) {
    const auto* list = v.as<Value::Array>();
    if (list == nullptr || list->size() != 4)
      return detail::wrong_type(v, at, allowed(spec), faults);
    for (std::size_t i = 0; i < 3; ++i)
      read_value((*list)[i], at.at(i), power, faults, out.powers[i]);
    read_value((*list)[3], at.at(3), spec, faults, out.coefficient);
  }
  static Value write(const AlgebraicTerm& term) {
    const auto& n = term.powers;
    return Value::Array{n[0], n[1], n[2], term.coefficient};
  }
  static Value schema(const Spec& spec) {
    const Value i = Codec<int>::schema(power), c = Codec<double>::schema(spec);
    return Value::Object{{"type", "array"},
                         {"prefixItems", Value::Array{i, i, i, c}},
                         {"minItems", 4},
                         {"maxItems", 4}};
  }
  static std::string allowed(const Spec& spec) {
    return "[i, j, k, c], i, j and k each " + Codec<int>::allowed(power) + ", c " +
           Codec<double>::allowed(spec);
  }
};

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
          Spec{.about = "[i, j, k, c] for c x^i y^j z^k, i + j + k at most 32; inside where the "
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
  std::vector<AlgebraicTerm> terms;  ///< each powers once, the highest first: x's, then y's, z's
  std::optional<Region> region;
};

AlgebraicForm prepare(const Algebraic& algebraic);
/// A term is expanded once a line; isolating the roots goes with the square of the degree.
inline int work_of(const AlgebraicForm& a) {
  int degree = 0;
  for (const AlgebraicTerm& term : a.terms) degree = std::max(degree, term.degree());
  return 16 + static_cast<int>(a.terms.size()) + degree * degree;
}
inline int elements(const AlgebraicForm& a) { return 1 + (a.region ? elements(*a.region) : 0); }
inline Aabb bounds(const AlgebraicForm& a) {
  return a.region ? bounds(*a.region) : Aabb::everything();
}

/// AlgebraicRoots: where a line changes sides within the bounds, ascending, and the side on which
/// it starts. A touching root stands twice.
struct AlgebraicRoots {
  Chord within;  ///< the line's stretch within the bounds, all of it where there are none
  bool starts_inside = false;
  int count = 0;
  std::array<double, most_algebraic_degree> t{};

  bool ends_inside() const { return starts_inside != (count % 2 == 1); }
};
AlgebraicRoots roots(const AlgebraicForm& algebraic, const Line& line);

/// The crossings of the solid: what is inside the surface and the bounds, closed by these.
template <class Emit>
void spans(const AlgebraicForm& algebraic, const Line& line, Emit&& emit) {
  const AlgebraicRoots found = roots(algebraic, line);
  if (found.starts_inside) emit(found.within.in.t, found.within.in.element);
  for (int i = 0; i < found.count; ++i) emit(found.t[static_cast<std::size_t>(i)], 0);
  if (found.ends_inside()) emit(found.within.out.t, found.within.out.element);
}

/// The surface's crossings, those within the bounds. Where there are bounds they make no pairs:
/// CSG wants spans.
template <class Emit>
void crossings(const AlgebraicForm& algebraic, const Line& line, Emit&& emit) {
  if (!algebraic.region) return spans(algebraic, line, emit);
  const AlgebraicRoots found = roots(algebraic, line);
  for (int i = 0; i < found.count; ++i) emit(found.t[static_cast<std::size_t>(i)], 0);
}

/// The gradient's direction; where it is 0, at a singular point, or too great for a double: +y.
Vec3d normal(const AlgebraicForm& algebraic, const Vec3d& p, int element);
/// Returns: longitude and latitude, as a sphere has them, around the middle of the bounds (the
/// origin if there are none); on the bounds' faces theirs.
Vec2d uv(const AlgebraicForm& algebraic, const Vec3d& p, int element);

static_assert(IsForm<AlgebraicForm>);

}  // namespace tia
