// The functions of formulas over intervals: exponentials, waves, angles, powers.
#pragma once

#include "core/math/deterministic.h"
#include "core/math/interval.h"
#include "core/math/powers.h"

namespace tia {

template <class S>
Interval<S> exp_of(const Interval<S>& a) {
  const auto e = interval::rising(a, [](const S& x) { return exp_of(x); });
  return {tia::max_of(e.lo, S(0)), e.hi};
}
template <class S>
Interval<S> log_of(const Interval<S>& a, Definedness<S>& where) {
  where.need(a.lo > S(0), a.hi >= S(0));  // the logarithm of 0 is -infinity
  const Interval<S> b{tia::max_of(a.lo, S(0)), tia::max_of(a.hi, S(0))};
  return interval::rising(b, [](const S& x) { return log_of(x); });
}

namespace interval {

/// Beyond it the angle's own digits are no more than whole turns can bear.
inline constexpr double most_angle = 1e9;
/// Whether offset + k period lies in a for some whole k; perhaps, where it is close.
template <class S>
Mask<S> meets(const Interval<S>& a, double offset, double period) {
  const S from = (a.lo - S(offset)) * S(1 / period), to = (a.hi - S(offset)) * S(1 / period);
  // What rounding and the last digit of the period come to: much at great angles only, so that next
  // to a pole, however close, a tangent stays bounded.
  const S slack = S(0x1p-48) * (S(1) + tia::max_of(abs_of(from), abs_of(to)));
  return floor_of(S(to + slack)) > floor_of(S(from - slack));
}
template <class S>
Mask<S> is_far(const Interval<S>& a) {
  return !(a.lo >= S(-most_angle) && a.hi <= S(most_angle));
}
/// Of sincos_of, which is within 3.5 ulp.
inline constexpr double sincos_rounding = 0x1p-49;
/// What lies between two values of a sine or cosine, and its extremes where it passes them.
template <class S>
Interval<S> wave(const S& from, const S& to, const Mask<S>& bottom, const Mask<S>& top) {
  const auto ends = outwards(tia::min_of(from, to), tia::max_of(from, to), sincos_rounding);
  return {select(bottom, S(-1), tia::max_of(ends.lo, S(-1))),
          select(top, S(1), tia::min_of(ends.hi, S(1)))};
}

}  // namespace interval

template <class S>
SineCosine<Interval<S>> sincos_of(const Interval<S>& a) {
  using interval::meets;
  const SineCosine<S> from = sincos_of(a.lo), to = sincos_of(a.hi);
  const Mask<S> anything = interval::is_far(a);
  const auto at = [&](double quarters) {
    return anything || meets(a, quarters * (pi / 2), 2 * pi);
  };
  return {interval::wave<S>(from.sine, to.sine, at(3), at(1)),
          interval::wave<S>(from.cosine, to.cosine, at(2), at(0))};
}
template <class S>
Interval<S> sin_of(const Interval<S>& a) {
  return sincos_of(a).sine;
}
template <class S>
Interval<S> cos_of(const Interval<S>& a) {
  return sincos_of(a).cosine;
}
template <class S>
Interval<S> tan_of(const Interval<S>& a, Definedness<S>& where) {
  const Mask<S> pole = interval::is_far(a) || interval::meets(a, pi / 2, pi);
  where.need(!pole);
  const auto own = interval::rising(a, [](const S& x) { return tan_of(x); });
  return interval::select_of<S>(pole, interval::everything<S>(), own);
}

namespace interval {
/// Arcsine and arccosine are defined from -1 to 1.
template <class S>
Interval<S> cosines(const Interval<S>& a, Definedness<S>& where) {
  where.need(a.lo >= S(-1) && a.hi <= S(1), a.lo <= S(1) && a.hi >= S(-1));
  const auto inside = [](const S& x) { return tia::max_of(tia::min_of(x, S(1)), S(-1)); };
  return {inside(a.lo), inside(a.hi)};
}
}  // namespace interval

template <class S>
Interval<S> asin_of(const Interval<S>& a, Definedness<S>& where) {
  return interval::rising(interval::cosines(a, where), [](const S& x) { return asin_of(x); });
}
template <class S>
Interval<S> acos_of(const Interval<S>& a, Definedness<S>& where) {
  const auto b = interval::cosines(a, where);
  return interval::outwards(S(acos_of(b.hi)), S(acos_of(b.lo)), interval::function_rounding);
}
template <class S>
Interval<S> atan_of(const Interval<S>& a) {
  return interval::rising(a, [](const S& x) { return atan_of(x); });
}
namespace interval {
// Less than sinh 709 and cosh 709: somewhat beyond, SLEEF's are infinite where a double is not yet.
inline constexpr double most_hyperbolic = 4e307;
}  // namespace interval

template <class S>
Interval<S> sinh_of(const Interval<S>& a) {
  const S most(interval::most_hyperbolic);
  const auto s = interval::rising(a, [](const S& x) { return sinh_of(x); });
  return {tia::min_of(s.lo, most), tia::max_of(s.hi, S(-most))};
}
template <class S>
Interval<S> cosh_of(const Interval<S>& a) {
  const S most(interval::most_hyperbolic);
  const auto c = interval::rising(abs_of(a), [](const S& x) { return cosh_of(x); });
  return {tia::max_of(tia::min_of(c.lo, most), S(1)), c.hi};
}
template <class S>
Interval<S> tanh_of(const Interval<S>& a) {
  return interval::rising(a, [](const S& x) { return tanh_of(x); });
}

namespace interval {
/// A function of two numbers that in each of them alone only rises or only falls has its extremes
/// in the corners.
template <class S, class F>
Interval<S> corners(const Interval<S>& a, const Interval<S>& b, F f) {
  const S p = f(a.lo, b.lo), q = f(a.lo, b.hi), r = f(a.hi, b.lo), s = f(a.hi, b.hi);
  return outwards(tia::min_of(tia::min_of(p, q), tia::min_of(r, s)),
                  tia::max_of(tia::max_of(p, q), tia::max_of(r, s)), function_rounding);
}
}  // namespace interval

/// The angle of (x, y); cut along the negative x axis.
template <class S>
Interval<S> atan2_of(const Interval<S>& y, const Interval<S>& x, Definedness<S>& where) {
  const Mask<S> cut = holds_zero(y) && x.lo <= S(0);
  where.need(!cut);
  const auto angle = interval::corners(y, x, [](const S& b, const S& a) { return atan2_of(b, a); });
  const S half_turn(pi * (1 + interval::function_rounding));
  return interval::select_of<S>(cut, Interval<S>{-half_turn, half_turn}, angle);
}

/// a^b, which for numbers below 0 is undefined.
template <class S>
Interval<S> pow_of(const Interval<S>& a, const Interval<S>& b, Definedness<S>& where) {
  where.need(a.lo > S(0) || (a.lo >= S(0) && b.lo > S(0)), a.hi >= S(0));
  const Interval<S> base{tia::max_of(a.lo, S(0)), tia::max_of(a.hi, S(0))};
  const auto p = interval::corners(base, b, [](const S& x, const S& y) { return pow_of(x, y); });
  return {tia::max_of(p.lo, S(0)), p.hi};
}

}  // namespace tia
