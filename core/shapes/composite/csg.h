// Constructive solid geometry: solids out of solids, by merging where a line runs inside them.
// Source: Roth, "Ray Casting for Modeling Solids", CGIP 18 (1982).
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "core/input/fields.h"

namespace tia {

struct Object;

/// What of its children a solid keeps: any's inside, every one's inside, the first's without the
/// others'.
enum class Operation { union_, intersection, difference };
template <>
struct Names<Operation> {
  static constexpr std::array<std::string_view, 3> names{"union", "intersection", "difference"};
};

/// Csg: a solid made of solids, which may be Csg themselves.
struct Csg {
  static constexpr std::string_view type = "csg";
  static constexpr bool one_object = true;
  Operation operation = Operation::union_;
  std::vector<Object> children;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("operation", &Csg::operation,
          Spec{.about = "what is kept of the children", .required = true});
    visit("children", &Csg::children, Spec{.about = "solids", .required = true, .min_items = 1});
  }
  bool operator==(const Csg&) const;
};
inline const std::vector<Object>& children_in(const Csg& csg) { return csg.children; }

/// Boundary: where a line enters or leaves a solid, and whose surface is there.
struct Boundary {
  double t = 0;
  int primitive = 0, element = 0;
};

/// Spans: a line's boundaries, ascending: in, out, in, out, ... An infinite t has no surface.
using Spans = std::vector<Boundary>;

/// Puts into `result` what a line runs through in two solids, merged; difference is a without b.
///
/// The half-open rule: a span holds where it begins and not where it ends, and boundaries no
/// farther apart than `same` and the rounding of t are one. So coincident faces show one surface,
/// that of `a`; a solid less its own copy is nothing; two solids that touch have no face between
/// them in their union and nothing in common; and what is thinner is nothing.
void merge(Operation operation, const Spans& a, const Spans& b, double same, Spans& result);

}  // namespace tia
