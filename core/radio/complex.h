// Complex numbers of doubles by the school's formulas: std::complex leaves to the compiler how it
// multiplies, divides and treats infinities.
#pragma once

#include <cmath>

#include "core/math/deterministic.h"

namespace tia {

struct Complex {
  double re = 0, im = 0;
  bool operator==(const Complex&) const = default;
};

inline Complex operator+(const Complex& a, const Complex& b) { return {a.re + b.re, a.im + b.im}; }
inline Complex operator-(const Complex& a, const Complex& b) { return {a.re - b.re, a.im - b.im}; }
inline Complex operator-(const Complex& a) { return {-a.re, -a.im}; }
inline Complex operator*(const Complex& a, const Complex& b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
inline Complex operator*(const Complex& a, double s) { return {a.re * s, a.im * s}; }
inline Complex operator*(double s, const Complex& a) { return a * s; }
/// |a|^2.
inline double norm_of(const Complex& a) { return a.re * a.re + a.im * a.im; }
/// Domain: b is not 0, and |b|^2 neither over- nor underflows.
inline Complex operator/(const Complex& a, const Complex& b) {
  const double inverse = 1 / norm_of(b);
  return {(a.re * b.re + a.im * b.im) * inverse, (a.im * b.re - a.re * b.im) * inverse};
}

/// The root with a real part >= 0; of a negative number the one below the axis, as the limit of
/// what is lossy. Domain: |a|^2 neither over- nor underflows.
inline Complex sqrt_of(const Complex& a) {
  if (a.im == 0) return a.re >= 0 ? Complex{std::sqrt(a.re), 0} : Complex{0, -std::sqrt(-a.re)};
  const double size = std::sqrt(norm_of(a));
  // The larger part first, for which nothing cancels.
  const double larger = std::sqrt((size + std::fabs(a.re)) / 2), other = a.im / (2 * larger);
  if (a.re >= 0) return {larger, other};
  return {std::fabs(other), std::copysign(larger, a.im)};
}

/// e^{j angle}. Domain: radians, |angle| < 1e14.
inline Complex turn(double angle) {
  const auto [sine, cosine] = sincos_of(angle);
  return {cosine, sine};
}

}  // namespace tia
