// The root of a function in a bracket, on one line or on eight.
#pragma once

#include "core/formulas/program.h"
#include "core/math/ray.h"

namespace tia::detail {

/// Bracketed: a stretch of a line in which a function changes its sign once, and a guess of where.
template <class Real>
struct Bracketed {
  Real from, to, guess;
  Mask<Real> inside_from;  ///< whether the function is below 0 before the root
  Real tolerance;          ///< how far off the root may be where it is found by bisection alone
};

/// The function and its derivative along the line.
template <class Real>
Dual<Real, 1> value_and_slope(const Program& function, const Ray<Real>& line, const Real& t) {
  using D = Dual<Real, 1>;
  const Vec3<Real> p = line.at(t), &d = line.direction;
  const std::array<D, 3> variables{D{p.x, {d.x}}, D{p.y, {d.y}}, D{p.z, {d.z}}};
  return evaluate(function, variables.data());
}

/// Newton's method within a bracket, which shrinks with each step; bisection where a step leaves
/// the bracket or converges too slowly. Source: Press et al., Numerical Recipes (2007), 9.4,
/// rtsafe.
template <class Real>
Real root_of(const Program& function, const Ray<Real>& line, const Bracketed<Real>& in) {
  constexpr int most_steps = 120;
  const Real half(0.5);
  Real from = in.from, to = in.to, last = to - from;
  // The error after a step is about its square: 2^-56 of the bracket after one of 2^-28.
  const Real close = max_of(in.tolerance, Real(0x1p-28) * last);
  Real t = select(in.guess > from && in.guess < to, in.guess, (from + to) * half);
  Mask<Real> done = !(from <= to);  // NaN
  for (int i = 0; i < most_steps && any(!done); ++i) {
    const auto [value, slope] = value_and_slope(function, line, t);
    const Mask<Real> zero = value == Real(0.0);
    const Mask<Real> before = (value < Real(0.0)) == in.inside_from;
    from = select(before, t, from);
    to = select(before, to, t);
    const Real newton = t - value / slope[0];
    const Mask<Real> good =
        newton > from && newton < to && Real(2.0) * abs_of(value) <= abs_of(last * slope[0]);
    const Real next = select(good, newton, from + (to - from) * half);
    last = next - t;
    t = select(done || zero, t, next);
    done = done || zero || abs_of(last) <= select(good, close, in.tolerance);
  }
  return t;
}

}  // namespace tia::detail
