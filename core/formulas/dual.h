// Dual numbers: a value and its derivatives by N variables, exact for every function of formulas.
// Over intervals they enclose both. Source: Griewank, Walther, Evaluating Derivatives (2008),
// ch. 3.
#pragma once

#include <array>

#include "core/formulas/scalars.h"

namespace tia {

template <class T, std::size_t N>
struct Dual {
  T value{};
  std::array<T, N> slope{};

  Dual() = default;
  Dual(double number) : value(number) { slope.fill(T(0)); }
  Dual(const T& v, const std::array<T, N>& d) : value(v), slope(d) {}
  /// The variable that the i-th slope is by.
  static Dual variable(const T& v, std::size_t i) {
    Dual dual(0.0);
    dual.value = v;
    dual.slope[i] = T(1);
    return dual;
  }
};

template <class T, std::size_t N>
struct FormulaTraits<Dual<T, N>> {
  using Where = WhereOf<T>;
};

namespace detail {

/// A dual of that value whose slopes are f of the others' slopes, one by one.
template <class T, std::size_t N, class F, class... Duals>
Dual<T, N> dual_of(const T& value, F f, const Dual<T, N>& first, const Duals&... others) {
  Dual<T, N> result;
  result.value = value;
  for (std::size_t i = 0; i < N; ++i) result.slope[i] = f(first.slope[i], others.slope[i]...);
  return result;
}
/// A function of a, by the chain rule.
template <class T, std::size_t N>
Dual<T, N> chain(const T& value, const T& derivative, const Dual<T, N>& a) {
  return dual_of(
      value, [&](const T& d) { return chained(d, derivative); }, a);
}

}  // namespace detail

template <class T, std::size_t N>
Dual<T, N> operator+(const Dual<T, N>& a, const Dual<T, N>& b) {
  return detail::dual_of(
      T(a.value + b.value), [](const T& x, const T& y) { return T(x + y); }, a, b);
}
template <class T, std::size_t N>
Dual<T, N> operator-(const Dual<T, N>& a, const Dual<T, N>& b) {
  return detail::dual_of(
      T(a.value - b.value), [](const T& x, const T& y) { return T(x - y); }, a, b);
}
template <class T, std::size_t N>
Dual<T, N> operator-(const Dual<T, N>& a) {
  return detail::dual_of(
      T(-a.value), [](const T& x) { return T(-x); }, a);
}
template <class T, std::size_t N>
Dual<T, N> operator*(const Dual<T, N>& a, const Dual<T, N>& b) {
  return detail::dual_of(
      T(a.value * b.value),
      [&](const T& x, const T& y) { return T(chained(x, b.value) + chained(y, a.value)); }, a, b);
}
template <class T, std::size_t N, class Where>
Dual<T, N> quotient(const Dual<T, N>& a, const Dual<T, N>& b, Where& where) {
  const T q = quotient(a.value, b.value, where);
  return detail::dual_of(
      q, [&](const T& x, const T& y) { return enclosed_quotient(T(x - chained(y, q)), b.value); },
      a, b);
}
template <class T, std::size_t N>
Dual<T, N> whole_power(const Dual<T, N>& a, int n) {
  const T lower = n == 1 ? T(1.0) : whole_power(a.value, n - 1);
  return detail::chain(whole_power(a.value, n), T(T(static_cast<double>(n)) * lower), a);
}
template <class T, std::size_t N>
Dual<T, N> abs_of(const Dual<T, N>& a) {
  return detail::chain(T(abs_of(a.value)), slope_of_abs(a.value), a);
}
template <class T, std::size_t N>
Dual<T, N> lesser(const Dual<T, N>& a, const Dual<T, N>& b) {
  return detail::dual_of(
      lesser(a.value, b.value),
      [&](const T& x, const T& y) { return slope_of_lesser(a.value, b.value, x, y); }, a, b);
}
template <class T, std::size_t N>
Dual<T, N> greater(const Dual<T, N>& a, const Dual<T, N>& b) {
  return detail::dual_of(
      greater(a.value, b.value),
      [&](const T& x, const T& y) { return slope_of_lesser(b.value, a.value, x, y); }, a, b);
}
template <class T, std::size_t N, class Where>
Dual<T, N> floor_of(const Dual<T, N>& a, Where& where) {
  return detail::chain(floor_of(a.value, where), T(0.0), a);
}
template <class T, std::size_t N, class Where>
Dual<T, N> sqrt_of(const Dual<T, N>& a, Where& where) {
  const T root = sqrt_of(a.value, where);
  return detail::chain(root, enclosed_quotient(T(0.5), root), a);
}
template <class T, std::size_t N>
Dual<T, N> hypot_of(const Dual<T, N>& a, const Dual<T, N>& b) {
  const T by_a = share_of_hypot(a.value, b.value), by_b = share_of_hypot(b.value, a.value);
  return detail::dual_of(
      hypot_of(a.value, b.value),
      [&](const T& x, const T& y) { return T(chained(x, by_a) + chained(y, by_b)); }, a, b);
}
template <class T, std::size_t N>
Dual<T, N> exp_of(const Dual<T, N>& a) {
  const T e = exp_of(a.value);
  return detail::chain(e, e, a);
}
template <class T, std::size_t N, class Where>
Dual<T, N> log_of(const Dual<T, N>& a, Where& where) {
  return detail::chain(log_of(a.value, where), enclosed_quotient(T(1.0), a.value), a);
}
template <class T, std::size_t N>
SineCosine<Dual<T, N>> sincos_of(const Dual<T, N>& a) {
  const SineCosine<T> both = sincos_of(a.value);
  return {detail::chain(both.sine, both.cosine, a), detail::chain(both.cosine, T(-both.sine), a)};
}
template <class T, std::size_t N, class Where>
Dual<T, N> tan_of(const Dual<T, N>& a, Where& where) {
  const T t = tan_of(a.value, where);
  return detail::chain(t, T(T(1.0) + whole_power(t, 2)), a);
}
template <class T, std::size_t N, class Where>
Dual<T, N> asin_of(const Dual<T, N>& a, Where& where) {
  Where slopes;
  const T root = sqrt_of(T(T(1.0) - whole_power(a.value, 2)), slopes);
  return detail::chain(asin_of(a.value, where), enclosed_quotient(T(1.0), root), a);
}
template <class T, std::size_t N, class Where>
Dual<T, N> acos_of(const Dual<T, N>& a, Where& where) {
  Where slopes;
  const T root = sqrt_of(T(T(1.0) - whole_power(a.value, 2)), slopes);
  return detail::chain(acos_of(a.value, where), enclosed_quotient(T(-1.0), root), a);
}
template <class T, std::size_t N>
Dual<T, N> atan_of(const Dual<T, N>& a) {
  const T square = whole_power(a.value, 2);
  return detail::chain(T(atan_of(a.value)), enclosed_quotient(T(1.0), T(T(1.0) + square)), a);
}
template <class T, std::size_t N, class Where>
Dual<T, N> atan2_of(const Dual<T, N>& y, const Dual<T, N>& x, Where& where) {
  const T square = whole_power(x.value, 2) + whole_power(y.value, 2);
  return detail::dual_of(
      T(atan2_of(y.value, x.value, where)),
      [&](const T& dy, const T& dx) {
        return enclosed_quotient(T(chained(dy, x.value) - chained(dx, y.value)), square);
      },
      y, x);
}
template <class T, std::size_t N>
Dual<T, N> sinh_of(const Dual<T, N>& a) {
  return detail::chain(T(sinh_of(a.value)), T(cosh_of(a.value)), a);
}
template <class T, std::size_t N>
Dual<T, N> cosh_of(const Dual<T, N>& a) {
  return detail::chain(T(cosh_of(a.value)), T(sinh_of(a.value)), a);
}
template <class T, std::size_t N>
Dual<T, N> tanh_of(const Dual<T, N>& a) {
  const T t = tanh_of(a.value);
  return detail::chain(t, T(T(1.0) - whole_power(t, 2)), a);
}
template <class T, std::size_t N, class Where>
Dual<T, N> pow_of(const Dual<T, N>& a, const Dual<T, N>& b, Where& where) {
  Where slopes;
  const T power = pow_of(a.value, b.value, where);
  const T by_base = b.value * pow_of(a.value, T(b.value - T(1.0)), slopes);
  const T by_exponent = chained(power, log_of(a.value, slopes));
  return detail::dual_of(
      power,
      [&](const T& x, const T& y) { return T(chained(x, by_base) + chained(y, by_exponent)); }, a,
      b);
}

}  // namespace tia
