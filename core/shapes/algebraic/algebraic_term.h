// The term of a polynomial in x, y and z, as scenes write it.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "core/input/codec.h"

namespace tia {

/// The highest total degree i + j + k of a term.
inline constexpr int most_algebraic_degree = 64;
inline constexpr std::size_t most_coefficients = most_algebraic_degree + 1;

/// AlgebraicTerm: coefficient * x^i y^j z^k. In JSON [i, j, k, coefficient].
struct AlgebraicTerm {
  std::array<int, 3> powers{};
  double coefficient = 0;

  int degree() const { return powers[0] + powers[1] + powers[2]; }
  bool operator==(const AlgebraicTerm&) const = default;
};

/// The terms with like powers added up, without those that are 0, the highest powers first: x's,
/// then y's, then z's.
std::vector<AlgebraicTerm> collected(std::vector<AlgebraicTerm> terms);

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

}  // namespace tia
