// Interval arithmetic, rounded outwards: whatever a formula's value is at a point of a box, it is
// inside the interval that the box gives. For one box (double) and for eight at once (Octet).
// Source: Moore, Kearfott, Cloud, Introduction to Interval Analysis (2009).
#pragma once

#include "core/math/octet.h"

namespace tia {

/// Interval: all numbers from lo to hi, which may be infinite. lo <= hi; lo is never +infinity, hi
/// never -infinity.
template <class S>
struct Interval {
  S lo{}, hi{};

  Interval() = default;
  Interval(double number) : lo(number), hi(number) {}
  Interval(const S& from, const S& to) : lo(from), hi(to) {}
  /// Inside of it. Domain: finite bounds that are 0 or not denormal.
  S middle() const { return lo * S(0.5) + hi * S(0.5); }
  S width() const { return hi - lo; }
};

/// Definedness: where on its box a formula has been seen to be defined. It gathers while a formula
/// is evaluated: what is undefined anywhere inside of it is undefined as a whole. It knows real
/// numbers: where doubles overflow, what is whole may yet come out as inf - inf.
template <class S>
struct Definedness {
  Mask<S> whole;  ///< defined and continuous on the whole box
  Mask<S> some;   ///< perhaps defined at some point of it

  Definedness() : whole(true_mask()), some(true_mask()) {}
  void need(const Mask<S>& everywhere, const Mask<S>& anywhere) {
    whole = whole && everywhere;
    some = some && anywhere;
  }
  void need(const Mask<S>& everywhere) { whole = whole && everywhere; }

 private:
  static Mask<S> true_mask() { return S(0) <= S(0); }
};

namespace interval {

inline constexpr double far = std::numeric_limits<double>::infinity();
inline constexpr double most = std::numeric_limits<double>::max();
// Of a value that is rounded to nearest: twice what that may be off.
inline constexpr double rounding = 0x1p-52;
// Of SLEEF's functions, which are within 1 ulp, that is, 2^-52 of the value.
inline constexpr double function_rounding = 0x1p-51;
// What numbers near 0 may be off, where doubles thin out.
inline constexpr double least = 0x1p-1022;

template <class S>
[[gnu::always_inline]] inline S down(const S& x, double slack = rounding) {
  const S y = min_of(S(most), x);  // NaN stays
  return y - (abs_of(y) * S(slack) + S(least));
}
template <class S>
[[gnu::always_inline]] inline S up(const S& x, double slack = rounding) {
  const S y = max_of(S(-most), x);
  return y + (abs_of(y) * S(slack) + S(least));
}
template <class S>
[[gnu::always_inline]] inline Interval<S> outwards(const S& lo, const S& hi,
                                                   double slack = rounding) {
  return {down(lo, slack), up(hi, slack)};
}
template <class S>
Interval<S> everything() {
  return {S(-far), S(far)};
}
/// A function that rises, of both ends.
template <class S, class F>
Interval<S> rising(const Interval<S>& a, F f) {
  return outwards(S(f(a.lo)), S(f(a.hi)), function_rounding);
}
template <class S>
[[gnu::always_inline]] inline Interval<S> select_of(const Mask<S>& mask, const Interval<S>& a,
                                                    const Interval<S>& b) {
  return {select(mask, a.lo, b.lo), select(mask, a.hi, b.hi)};
}
/// 0 where a bound of 0 met one of infinity: no number of the interval is infinite itself.
template <class S>
[[gnu::always_inline]] inline S product(const S& a, const S& b) {
  const S p = a * b;
  return select(p == p, p, S(0));
}

}  // namespace interval

template <class S>
[[gnu::always_inline]] inline Interval<S> hull(const Interval<S>& a, const Interval<S>& b) {
  return {min_of(a.lo, b.lo), max_of(a.hi, b.hi)};
}
/// What both hold. Domain: they have a number in common.
template <class S>
Interval<S> common(const Interval<S>& a, const Interval<S>& b) {
  return {max_of(a.lo, b.lo), min_of(a.hi, b.hi)};
}
template <class S>
[[gnu::always_inline]] inline Mask<S> holds_zero(const Interval<S>& a) {
  return a.lo <= S(0) && a.hi >= S(0);
}

namespace interval {
/// Of sums, which are exact where doubles thin out: so what is not below 0 stays so.
template <class S>
[[gnu::always_inline]] inline Interval<S> sum_outwards(const S& lo, const S& hi) {
  const S x = tia::min_of(S(most), lo), y = tia::max_of(S(-most), hi);
  return {x - abs_of(x) * S(rounding), y + abs_of(y) * S(rounding)};
}
}  // namespace interval

template <class S>
[[gnu::always_inline]] inline Interval<S> operator+(const Interval<S>& a, const Interval<S>& b) {
  return interval::sum_outwards(S(a.lo + b.lo), S(a.hi + b.hi));
}
template <class S>
[[gnu::always_inline]] inline Interval<S> operator-(const Interval<S>& a, const Interval<S>& b) {
  return interval::sum_outwards(S(a.lo - b.hi), S(a.hi - b.lo));
}
template <class S>
[[gnu::always_inline]] inline Interval<S> operator-(const Interval<S>& a) {
  return {-a.hi, -a.lo};
}
template <class S>
Interval<S> operator*(const Interval<S>& a, const Interval<S>& b) {
  using interval::product;
  const S p = product(a.lo, b.lo), q = product(a.lo, b.hi);
  const S r = product(a.hi, b.lo), s = product(a.hi, b.hi);
  return interval::outwards(min_of(min_of(p, q), min_of(r, s)), max_of(max_of(p, q), max_of(r, s)));
}
template <class S>
Interval<S> times(const Interval<S>& a, const S& factor) {
  return a * Interval<S>(factor, factor);
}

/// Everything where the divisor holds 0, whatever is asked of it.
template <class S>
Interval<S> enclosed_quotient(const Interval<S>& a, const Interval<S>& b) {
  const auto rounded = interval::outwards(S(S(1) / b.hi), S(S(1) / b.lo));
  // It has b's sign, and must keep it: what is rounded beyond 0 could meet infinity.
  const Interval<S> inverse{select(b.lo > S(0), tia::max_of(rounded.lo, S(0)), rounded.lo),
                            select(b.hi < S(0), tia::min_of(rounded.hi, S(0)), rounded.hi)};
  return interval::select_of<S>(holds_zero(b), interval::everything<S>(), a * inverse);
}
template <class S>
Interval<S> quotient(const Interval<S>& a, const Interval<S>& b, Definedness<S>& where) {
  where.need(!holds_zero(b));  // numbers divide by 0 alone too, and 1 / inf is defined again
  return enclosed_quotient(a, b);
}

template <class S>
[[gnu::always_inline]] inline Interval<S> abs_of(const Interval<S>& a) {
  const S low = max_of(max_of(a.lo, S(-a.hi)), S(0));
  return {low, max_of(S(-a.lo), a.hi)};
}
template <class S>
Interval<S> min_of(const Interval<S>& a, const Interval<S>& b) {
  return {tia::min_of(a.lo, b.lo), tia::min_of(a.hi, b.hi)};
}
template <class S>
Interval<S> max_of(const Interval<S>& a, const Interval<S>& b) {
  return {tia::max_of(a.lo, b.lo), tia::max_of(a.hi, b.hi)};
}
template <class S>
Interval<S> floor_of(const Interval<S>& a, Definedness<S>& where) {
  const Interval<S> steps{floor_of(a.lo), floor_of(a.hi)};
  where.need(steps.lo == steps.hi);
  return steps;
}
template <class S>
Interval<S> sqrt_of(const Interval<S>& a, Definedness<S>& where) {
  using std::sqrt;
  where.need(a.lo >= S(0), a.hi >= S(0));
  const auto root =
      interval::outwards(S(sqrt(tia::max_of(a.lo, S(0)))), S(sqrt(tia::max_of(a.hi, S(0)))));
  return {tia::max_of(root.lo, S(0)), root.hi};
}

/// x^n of a number, by squaring. Domain: n >= 0.
template <class S>
S whole_power(S x, int n) {
  S result(1);
  for (; n > 0; n >>= 1) {
    if ((n & 1) != 0) result = result * x;
    if (n > 1) x = x * x;
  }
  return result;
}
/// a^n, with even powers nowhere below 0. Domain: n >= 1.
template <class S>
Interval<S> whole_power(const Interval<S>& a, int n) {
  const double slack = (n + 1) * interval::rounding;
  if (n % 2 == 1) return interval::outwards(whole_power(a.lo, n), whole_power(a.hi, n), slack);
  const Interval<S> b = abs_of(a);
  const auto power = interval::outwards(whole_power(b.lo, n), whole_power(b.hi, n), slack);
  return {tia::max_of(power.lo, S(0)), power.hi};
}

}  // namespace tia
