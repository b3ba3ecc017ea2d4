// Real roots of polynomials in double: the quadratic in closed form, any degree by isolation.
#pragma once

#include <cmath>
#include <span>

namespace tia {

/// QuadraticRoots: the real roots in ascending order; a touching one counts twice.
struct QuadraticRoots {
  int count = 0;
  double t0 = 0, t1 = 0;  ///< of one root only t0
};

/// The roots of a t^2 + 2 half_b t + c; of a line where a = 0; none where all t are alike (or NaN).
/// Source: Press et al., Numerical Recipes (2007), 5.6: the form that subtracts no like numbers.
inline QuadraticRoots quadratic_roots(double a, double half_b, double c) {
  if (a == 0) {
    if (half_b == 0) return {};
    return {1, -c / (2 * half_b), 0};
  }
  const double discriminant = half_b * half_b - a * c;
  if (!(discriminant >= 0)) return {};
  const double q = -(half_b + std::copysign(std::sqrt(discriminant), half_b));
  const double one = q / a, other = q == 0 ? 0 : c / q;
  return one < other ? QuadraticRoots{2, one, other} : QuadraticRoots{2, other, one};
}

/// RootBracket: where a root was searched for, between the interval's ends and the stationary
/// points that are not roots; low = high where the polynomial only touches zero.
struct RootBracket {
  double low, high;
};

/// The highest degree that real_roots takes.
inline constexpr int max_degree = 64;

/// The real roots of c[0] + c[1] t + c[2] t^2 + ... in [low, high], ascending, to within a few
/// steps of double at the interval's larger end, as far as the coefficients determine them.
///
/// Where p touches zero, that is, where |p| at a stationary point is no more than what rounding may
/// have made of it, the root stands twice (p keeps its sign) or once (it changes it). So whatever
/// is touched or missed by rounding, the number of roots is odd only if p(low) and p(high) differ
/// in sign.
/// Domain: finite low <= high, at most max_degree + 1 coefficients, and as many roots less one;
/// brackets for as many roots, or none, where nobody asks.
/// Returns: how many roots there are; 0 for a constant and where a coefficient is NaN.
/// Source: Yuksel, "High-Performance Polynomial Root Finding for Graphics", HPG 2022: between the
/// roots of its derivative a polynomial is monotone, so that Newton in brackets finds each root.
int real_roots(std::span<const double> c, double low, double high, std::span<double> roots,
               std::span<RootBracket> brackets = {});

}  // namespace tia
