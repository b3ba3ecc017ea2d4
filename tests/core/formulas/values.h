// The values and the derivatives of trees (trees.h), by recursion, in double or long double.
#pragma once

#include <optional>

#include "tests/core/formulas/trees.h"

namespace tia::test {

/// Those of the code under test for double, the C library's for long double.
#define TIA_OWN(name)                                   \
  static double name(double x) { return name##_of(x); } \
  static Long name(Long x) { return std::name(x); }
struct Functions {
  static double sin(double x) { return sincos_of(x).sine; }
  static Long sin(Long x) { return std::sin(x); }
  static double cos(double x) { return sincos_of(x).cosine; }
  static Long cos(Long x) { return std::cos(x); }
  TIA_OWN(tan)
  TIA_OWN(asin)
  TIA_OWN(acos)
  TIA_OWN(atan)
  TIA_OWN(sinh)
  TIA_OWN(cosh)
  TIA_OWN(tanh)
  TIA_OWN(exp)
  TIA_OWN(log)
  static double atan2(double y, double x) { return atan2_of(y, x); }
  static Long atan2(Long y, Long x) { return std::atan2(y, x); }
  static double pow(double a, double b) { return pow_of(a, b); }
  static Long pow(Long a, Long b) { return std::pow(a, b); }
};
#undef TIA_OWN

template <class R>
R undefined() {
  return std::numeric_limits<R>::quiet_NaN();
}
template <class R>
R product_of(R x, int n) {
  R result = 1;
  for (; n > 0; n /= 2) {
    if (n % 2 == 1) result *= x;
    if (n > 1) x *= x;
  }
  return result;
}
template <class R>
R applied(Op op, R a, R b) {
  using F = Functions;
  switch (op) {
    case Op::add: return a + b;
    case Op::subtract: return a - b;
    case Op::multiply: return a * b;
    case Op::divide: return a / b;
    case Op::negate: return -a;
    case Op::pow: return !(a >= 0) || std::isnan(b) ? undefined<R>() : F::pow(a == 0 ? R(0) : a, b);
    case Op::sqrt: return std::sqrt(a);
    case Op::abs: return std::fabs(a);
    case Op::min: return std::isnan(a) || std::isnan(b) ? undefined<R>() : std::min(b, a);
    case Op::max: return std::isnan(a) || std::isnan(b) ? undefined<R>() : std::max(b, a);
    case Op::floor: return std::floor(a);
    case Op::exp: return F::exp(a);
    case Op::log: return F::log(a);
    case Op::sin: return F::sin(a);
    case Op::cos: return F::cos(a);
    case Op::tan: return F::tan(a);
    case Op::asin: return F::asin(a);
    case Op::acos: return F::acos(a);
    case Op::atan: return F::atan(a);
    case Op::atan2: return F::atan2(a, b);
    case Op::sinh: return F::sinh(a);
    case Op::cosh: return F::cosh(a);
    case Op::tanh: return F::tanh(a);
    default: return undefined<R>();
  }
}

/// Evaluation: a tree at a point. Constant parts are the doubles that they round to, as in
/// formulas.
template <class R>
class Evaluation {
 public:
  explicit Evaluation(std::array<double, 3> at) : at_(at) {}

  /// Whether a number on the way was beyond R.
  bool overflowed() const { return overflowed_; }

  R value(const Tree& tree) {
    if (tree.op == Op::variable) return at_[static_cast<std::size_t>(tree.variable)];
    if (tree.op == Op::constant) return tree.number;
    if (const std::optional<double> known = folded(tree)) return *known;
    const R result = plain(tree);
    if (std::isinf(result)) overflowed_ = true;
    return result;
  }
  /// The derivative by a variable.
  R slope(const Tree& tree, int by) {
    if (tree.op == Op::variable) return tree.variable == by ? 1 : 0;
    if (folded(tree)) return 0;
    const R da = slope(*tree.a, by), a = value(*tree.a);
    if (!tree.b) return slope_of_one(tree, a) * da;
    return slope_of_two(tree, a, value(*tree.b), da, slope(*tree.b, by));
  }

 private:
  // The whole number that a power is to, if it is to one.
  static std::optional<int> whole_exponent(const Tree& tree) {
    if (tree.op != Op::pow) return {};
    const auto exponent = folded(*tree.b);
    if (!exponent || *exponent != std::floor(*exponent) || std::fabs(*exponent) > 256) return {};
    return static_cast<int>(*exponent);
  }
  static std::optional<double> folded(const Tree& tree) {
    if (tree.op == Op::constant) return tree.number;
    if (whole_exponent(tree) == 0) return 1;
    if (tree.op == Op::variable || !folded(*tree.a) || (tree.b && !folded(*tree.b))) return {};
    const double known = Evaluation<double>({}).plain(tree);
    if (!std::isfinite(known)) return {};
    return known == 0 ? 0 : known;
  }
  R plain(const Tree& tree) {
    const R a = value(*tree.a), b = tree.b ? value(*tree.b) : R(0);
    if (const auto n = whole_exponent(tree))
      return *n < 0 ? R(1) / product_of(a, -*n) : product_of(a, *n);
    if (tree.op == Op::pow && folded(*tree.b) == 0.5) return std::sqrt(a);
    return applied(tree.op, a, b);
  }
  R slope_of_one(const Tree& tree, R a) {
    using F = Functions;
    switch (tree.op) {
      case Op::negate: return -1;
      case Op::sqrt: return 1 / (2 * std::sqrt(a));
      case Op::abs: return a == 0 ? undefined<R>() : std::copysign(R(1), a);
      case Op::floor: return 0;
      case Op::exp: return F::exp(a);
      case Op::log: return a > 0 ? 1 / a : undefined<R>();
      case Op::sin: return F::cos(a);
      case Op::cos: return -F::sin(a);
      case Op::tan: return 1 / (F::cos(a) * F::cos(a));
      case Op::asin: return 1 / std::sqrt((1 - a) * (1 + a));
      case Op::acos: return -1 / std::sqrt((1 - a) * (1 + a));
      case Op::atan: return 1 / (1 + a * a);
      case Op::sinh: return F::cosh(a);
      case Op::cosh: return F::sinh(a);
      case Op::tanh: return 1 / (F::cosh(a) * F::cosh(a));
      default: return undefined<R>();
    }
  }
  R slope_of_two(const Tree& tree, R a, R b, R da, R db) {
    if (const auto n = whole_exponent(tree))
      return *n * (*n < 1 ? 1 / product_of(a, 1 - *n) : product_of(a, *n - 1)) * da;
    switch (tree.op) {
      case Op::add: return da + db;
      case Op::subtract: return da - db;
      case Op::multiply: return da * b + a * db;
      case Op::divide: return da / b - a / b * (db / b);
      case Op::min: return a == b ? undefined<R>() : a < b ? da : db;
      case Op::max: return a == b ? undefined<R>() : a < b ? db : da;
      case Op::atan2: return (da * b - db * a) / (a * a + b * b);
      case Op::pow:
        if (!(a > 0)) return undefined<R>();
        return Functions::pow(a, b) * (b / a * da + (folded(*tree.b) ? 0 : Functions::log(a) * db));
      default: return undefined<R>();
    }
  }

  template <class>
  friend class Evaluation;
  std::array<double, 3> at_;
  bool overflowed_ = false;
};

}  // namespace tia::test
