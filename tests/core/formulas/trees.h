// Random formulas as trees: printed as text for the parser, and evaluated and differentiated by
// recursion, in double or long double, apart from the code under test.
#pragma once

#include <charconv>
#include <memory>

#include "core/formulas/parse.h"
#include "core/math/deterministic.h"
#include "core/math/powers.h"
#include "tests/core/support.h"

namespace tia::test {

using Point = std::array<double, 3>;
struct Tree;
using TreePtr = std::shared_ptr<const Tree>;

/// Tree: an operation and its operands. Op::pow stands for every power.
struct Tree {
  Op op = Op::constant;
  TreePtr a{}, b{};
  int variable = 0;
  double number = 0;
};
inline TreePtr leaf(double number) {
  return std::make_shared<Tree>(Tree{Op::constant, nullptr, nullptr, 0, number});
}
inline TreePtr leaf(Op, int variable) {
  return std::make_shared<Tree>(Tree{Op::variable, nullptr, nullptr, variable, 0});
}
inline TreePtr node(Op op, TreePtr a, TreePtr b = nullptr) {
  return std::make_shared<Tree>(Tree{op, std::move(a), std::move(b), 0, 0});
}

inline const std::vector<std::string_view> variable_names{"x", "y", "z"};

/// The program of one formula of x, y and z.
inline Program program_of_xyz(const std::string& text,
                              const std::map<std::string, double>& parameters = {}) {
  return program_of({text}, {variable_names, parameters});
}

inline TreePtr any_tree(Random& random, int depth) {
  if (depth == 0 || random.chance(0.1)) {
    if (random.chance(0.75)) return leaf(Op::variable, random.below(3));
    return leaf(random.chance(0.5) ? random.below(5) : random.in(0, 4));
  }
  static constexpr std::array twos{Op::add, Op::subtract, Op::multiply, Op::divide,
                                   Op::min, Op::max,      Op::atan2};
  static constexpr std::array ones{Op::negate, Op::sqrt, Op::abs,  Op::floor, Op::exp,
                                   Op::log,    Op::sin,  Op::cos,  Op::tan,   Op::asin,
                                   Op::acos,   Op::atan, Op::sinh, Op::cosh,  Op::tanh};
  const double kind = random.unit();
  const TreePtr a = any_tree(random, depth - 1);
  if (kind < 0.1) {
    static constexpr std::array exponents{0.0, 1.0, 2.0, 3.0, 4.0, 7.0, 0.5, 2.5, 0.3};
    const TreePtr exponent = leaf(exponents[static_cast<std::size_t>(random.below(9))]);
    return node(Op::pow, a, random.chance(0.3) ? node(Op::negate, exponent) : exponent);
  }
  if (kind < 0.15) return node(Op::pow, a, any_tree(random, depth - 1));
  if (kind < 0.55) return node(ones[static_cast<std::size_t>(random.below(15))], a);
  const Op op =
      twos[static_cast<std::size_t>(random.chance(0.7) ? random.below(4) : 4 + random.below(3))];
  return node(op, a, any_tree(random, depth - 1));
}

// ---- as text --------------------------------------------------------------------------------

struct Printed {
  std::string text;
  int binding = 5;  ///< sums 1, products 2, signs 3, powers 4, what is whole 5
};
inline std::string space(Random& random) { return random.chance(0.1) ? " " : ""; }
inline std::string within(const Printed& part, int least, Random& random) {
  if (part.binding >= least && !random.chance(0.05)) return part.text;
  return "(" + space(random) + part.text + space(random) + ")";
}
inline Printed print(const Tree& tree, Random& random) {
  static const std::map<Op, const char*> names{
      {Op::sqrt, "sqrt"}, {Op::abs, "abs"},   {Op::min, "min"},   {Op::max, "max"},
      {Op::exp, "exp"},   {Op::log, "log"},   {Op::sin, "sin"},   {Op::cos, "cos"},
      {Op::tan, "tan"},   {Op::asin, "asin"}, {Op::acos, "acos"}, {Op::floor, "floor"},
      {Op::atan, "atan"}, {Op::sinh, "sinh"}, {Op::cosh, "cosh"}, {Op::atan2, "atan2"},
      {Op::tanh, "tanh"}};
  if (tree.op == Op::constant) {
    std::array<char, 40> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), tree.number);
    return {std::string(digits.data(), end.ptr), 5};
  }
  if (tree.op == Op::variable)
    return {std::string(variable_names[static_cast<std::size_t>(tree.variable)]), 5};
  const Printed a = print(*tree.a, random), b = tree.b ? print(*tree.b, random) : Printed{};
  if (tree.op == Op::negate) return {"-" + space(random) + within(a, 3, random), 3};
  const auto joined = [&](const char* sign, int left, int right, int own) {
    const std::string first = within(a, left, random) + space(random);
    return Printed{first + sign + space(random) + within(b, right, random), own};
  };
  switch (tree.op) {
    case Op::add: return joined("+", 1, 2, 1);
    case Op::subtract: return joined("-", 1, 2, 1);
    case Op::multiply: return joined("*", 2, 3, 2);
    case Op::divide: return joined("/", 2, 3, 2);
    case Op::pow: return joined("^", 5, 3, 4);
    default: break;
  }
  const std::string call = names.at(tree.op) + space(random) + "(" + a.text;
  return {call + (tree.b ? space(random) + "," + b.text : "") + ")", 5};
}

}  // namespace tia::test
