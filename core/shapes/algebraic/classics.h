// The named algebraic surfaces, each in the form and size that its books give it; a transform on
// the object grows, turns and moves them. They become algebraic surfaces.
#pragma once

#include <concepts>
#include <optional>
#include <string_view>
#include <vector>

#include "core/shapes/algebraic/algebraic.h"

namespace tia {

/// A named surface: the terms of a polynomial, which is below 0 inside, and what clips it.
template <class S>
concept IsClassic = requires(const S& s) {
  { s.terms() } -> std::same_as<std::vector<AlgebraicTerm>>;
  { s.bounds } -> std::convertible_to<std::optional<Bounds>>;
};

template <IsClassic S>
AlgebraicForm prepare(const S& classic) {
  return prepare(Algebraic{classic.terms(), classic.bounds});
}

namespace detail {
inline constexpr Spec clipping{.about = "what the surface is clipped to"};
}

/// Steiner's Roman surface. Surface: x^2 y^2 + y^2 z^2 + z^2 x^2 = x y z.
/// Space/units: object space; its four lobes reach to (1/3, 1/3, 1/3) and to the three other points
/// with the signs of two coordinates changed. The axes are lines of double points: within 1/2 of
/// the origin two sheets cross there, beyond there is nothing else.
/// Source: Apery, Models of the Real Projective Plane (1987).
struct Steiner {
  static constexpr std::string_view type = "steiner";
  std::optional<Bounds> bounds;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("bounds", &Steiner::bounds, detail::clipping);
  }
  std::vector<AlgebraicTerm> terms() const;
  bool operator==(const Steiner&) const = default;
};

/// Barth's sextic, of 65 nodes: the most that a sextic has. 15 of them are at infinity.
/// Surface: 4 (p^2 x^2 - y^2) (p^2 y^2 - z^2) (p^2 z^2 - x^2) = (1 + 2 p) (x^2 + y^2 + z^2 - 1)^2,
/// p the golden ratio. Space/units: object space; inside is where the left side is the lesser.
/// It has the symmetry of the icosahedron with a vertex on (p, 1, 0).
/// Source: Barth, "Two projective surfaces with many nodes, admitting the symmetries of the
/// icosahedron", J. Algebraic Geom. 5 (1996).
struct BarthSextic {
  static constexpr std::string_view type = "barth_sextic";
  std::optional<Bounds> bounds;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("bounds", &BarthSextic::bounds, detail::clipping);
  }
  std::vector<AlgebraicTerm> terms() const;
  bool operator==(const BarthSextic&) const = default;
};

/// Chmutov's surface. Surface: T(x) + T(y) + T(z) = 0, T Chebyshev's polynomial of degree `order`.
/// Space/units: object space; its pattern fills the cube from -1 to 1. Of even order it is bounded,
/// |x| <= 1.23 and less the higher the order, of odd order it goes on to infinity.
/// Source: Chmutov, "Examples of projective surfaces with many singularities", J. Algebraic Geom. 1
/// (1992); with every sign + as Banchoff draws it.
struct Chmutov {
  static constexpr std::string_view type = "chmutov";
  int order = 0;
  std::optional<Bounds> bounds;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("order", &Chmutov::order,
          Spec{.about = "the degree of T in T(x) + T(y) + T(z) = 0",
               .min = 2,
               .max = 20,
               .required = true});
    visit("bounds", &Chmutov::bounds, detail::clipping);
  }
  std::vector<AlgebraicTerm> terms() const;
  bool operator==(const Chmutov&) const = default;
};

/// The heart. Surface: (x^2 + 9/4 y^2 + z^2 - 1)^3 = x^2 z^3 + 9/80 y^2 z^3.
/// Space/units: object space; upright along z, flat along y, within 1.43 of the origin.
/// Source: Taubin, "An accurate algorithm for rasterizing algebraic curves and surfaces", IEEE
/// CG&A 14 (1994).
struct Heart {
  static constexpr std::string_view type = "heart";
  std::optional<Bounds> bounds;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("bounds", &Heart::bounds, detail::clipping);
  }
  std::vector<AlgebraicTerm> terms() const;
  bool operator==(const Heart&) const = default;
};

/// Clebsch's diagonal cubic, on which all 27 lines are real. Surface: 81 (x^3 + y^3 + z^3)
/// - 189 (x^2 y + x^2 z + y^2 x + y^2 z + z^2 x + z^2 y) + 54 x y z + 126 (x y + y z + z x)
/// - 9 (x^2 + y^2 + z^2) - 9 (x + y + z) + 1 = 0.
/// Space/units: object space; unbounded, its axis along (1, 1, 1).
/// Source: Hunt, The Geometry of Some Special Arithmetic Quotients (1996).
struct Clebsch {
  static constexpr std::string_view type = "clebsch";
  std::optional<Bounds> bounds;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("bounds", &Clebsch::bounds, detail::clipping);
  }
  std::vector<AlgebraicTerm> terms() const;
  bool operator==(const Clebsch&) const = default;
};

/// Cayley's cubic, of four nodes: the most that a cubic has.
/// Surface: 4 (x^2 + y^2 + z^2) + 16 x y z = 1.
/// Space/units: object space; unbounded, nodes at (-1/2, -1/2, -1/2) and at the three other points
/// with the signs of two coordinates changed.
/// Source: Hunt, as above.
struct Cayley {
  static constexpr std::string_view type = "cayley";
  std::optional<Bounds> bounds;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("bounds", &Cayley::bounds, detail::clipping);
  }
  std::vector<AlgebraicTerm> terms() const;
  bool operator==(const Cayley&) const = default;
};

}  // namespace tia
