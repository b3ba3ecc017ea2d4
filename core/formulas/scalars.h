// What formulas ask of their scalars: numbers (double, Octet), intervals of them (core/math) and
// duals of either (dual.h) answer to the same names. Here the numbers.
#pragma once

#include "core/math/interval_functions.h"

namespace tia {

template <class T>
inline constexpr bool is_number = std::is_same_v<T, double> || std::is_same_v<T, Octet>;
template <class T>
concept Number = is_number<T>;

/// Anywhere: the Definedness of numbers, which are NaN where a formula is undefined.
struct Anywhere {};

/// What goes with a scalar: what gathers where the formula is defined.
template <class T>
struct FormulaTraits {
  using Where = Anywhere;
};
template <class S>
struct FormulaTraits<Interval<S>> {
  using Where = Definedness<S>;
};
template <class T>
using WhereOf = typename FormulaTraits<T>::Where;

template <Number S>
S not_a_number() {
  return S(std::numeric_limits<double>::quiet_NaN());
}

template <Number S>
S quotient(const S& a, const S& b, Anywhere&) {
  return a / b;
}
template <Number S>
S enclosed_quotient(const S& a, const S& b) {
  return a / b;
}
template <Number S>
S sqrt_of(const S& a, Anywhere&) {
  using std::sqrt;
  return sqrt(a);
}
template <Number S>
S floor_of(const S& a, Anywhere&) {
  return floor_of(a);
}
template <Number S>
S log_of(const S& a, Anywhere&) {
  return log_of(a);
}
template <Number S>
S tan_of(const S& a, Anywhere&) {
  return tan_of(a);
}
template <Number S>
S asin_of(const S& a, Anywhere&) {
  return asin_of(a);
}
template <Number S>
S acos_of(const S& a, Anywhere&) {
  return acos_of(a);
}
template <Number S>
S atan2_of(const S& y, const S& x, Anywhere&) {
  return atan2_of(y, x);
}
/// From 0 up, whose sign does not count; undefined where a term is, even 1^b and a^0.
template <Number S>
S pow_of(const S& a, const S& b, Anywhere&) {
  return select(a >= S(0) && b == b, pow_of(abs_of(a), b), not_a_number<S>());
}

/// The lesser and the greater of two terms of a formula, undefined where one of them is.
template <Number S>
S lesser(const S& a, const S& b) {
  return select(a < b || !(a == a), a, b);
}
template <Number S>
S greater(const S& a, const S& b) {
  return select(a > b || !(a == a), a, b);
}
template <class S>
Interval<S> lesser(const Interval<S>& a, const Interval<S>& b) {
  return min_of(a, b);
}
template <class S>
Interval<S> greater(const Interval<S>& a, const Interval<S>& b) {
  return max_of(a, b);
}

/// The length of (a, b).
template <Number S>
S hypot_of(const S& a, const S& b) {
  using std::sqrt;
  return sqrt(a * a + b * b);
}
template <class S>
Interval<S> hypot_of(const Interval<S>& a, const Interval<S>& b) {
  const Interval<S> x = abs_of(a), y = abs_of(b);
  return interval::outwards(hypot_of(x.lo, y.lo), hypot_of(x.hi, y.hi), 2 * interval::rounding);
}

// ---- of derivatives -------------------------------------------------------------------------

/// A derivative times an inner one; what is constant stays so however steep the outer function is.
template <Number S>
S chained(const S& inner, const S& factor) {
  return select(inner == S(0), S(0), S(inner * factor));
}
template <class S>
Interval<S> chained(const Interval<S>& inner, const Interval<S>& factor) {
  return inner * factor;
}

/// The derivative of |x|.
template <Number S>
S slope_of_abs(const S& x) {
  return select(x < S(0), S(-1), S(1));
}
template <class S>
Interval<S> slope_of_abs(const Interval<S>& x) {
  return {select(x.lo > S(0), S(1), S(-1)), select(x.hi < S(0), S(-1), S(1))};
}

/// The derivative of hypot_of(a, b) by a, which is a's share of it: from -1 to 1.
template <Number S>
S share_of_hypot(const S& a, const S& b) {
  const S length = hypot_of(a, b);
  return select(length > S(0), S(a / length), S(0));
}
/// It rises with a, and is nearest to 0 where |b| is greatest.
template <class S>
Interval<S> share_of_hypot(const Interval<S>& a, const Interval<S>& b) {
  const Interval<S> other = abs_of(b);
  const S low = share_of_hypot(a.lo, select(a.lo < S(0), other.lo, other.hi));
  const S high = share_of_hypot(a.hi, select(a.hi > S(0), other.lo, other.hi));
  const auto share = interval::outwards(low, high, 4 * interval::rounding);
  // Where both may be 0 it may be anything of a's signs.
  const Mask<S> tip = holds_zero(a) && other.lo <= S(0);
  return {select(tip && a.lo < S(0), S(-1), max_of(share.lo, S(-1))),
          select(tip && a.hi > S(0), S(1), min_of(share.hi, S(1)))};
}

/// The derivative of the lesser of a and b, theirs being da and db; both, where either may be it.
template <Number S>
S slope_of_lesser(const S& a, const S& b, const S& da, const S& db) {
  return select(a < b, da, db);
}
template <class S>
Interval<S> slope_of_lesser(const Interval<S>& a, const Interval<S>& b, const Interval<S>& da,
                            const Interval<S>& db) {
  const auto either = hull(da, db);
  const auto second = interval::select_of<S>(b.hi < a.lo, db, either);
  return interval::select_of<S>(a.hi < b.lo, da, second);
}

}  // namespace tia
