// Functions beyond + - * / sqrt, the same bits on every processor. They come from SLEEF's
// deterministic, FMA-free scalar variants, never from libm, whose variants the processor picks.
#pragma once

namespace tia {

inline constexpr double pi = 3.14159265358979323846;

/// Domain: radians, |x| < 1e14. Returns: tan x within 1 ulp.
double tan_of(double radians);
/// Domain: radians, |x| < 1e14. Returns: within 1 ulp.
double sin_of(double radians);
double cos_of(double radians);

/// SineCosine: both of one angle, for little more than one of them.
template <class S>
struct SineCosine {
  S sine, cosine;
};
/// Domain: radians, |x| < 1e14. Returns: each within 3.5 ulp.
SineCosine<double> sincos_of(double radians);
/// Returns: the angle of the point (x, y), radians in [-pi, pi], within 1 ulp.
double atan2_of(double y, double x);
/// Returns: the angle in (-pi/2, pi/2), within 1 ulp.
double atan_of(double x);
/// Domain: |x| <= 1. Returns: radians within 1 ulp.
double asin_of(double x);
double acos_of(double x);
/// Returns: within 1 ulp; infinite beyond what a double holds.
double sinh_of(double x);
double cosh_of(double x);
double tanh_of(double x);
/// Domain: x >= 0. Returns: within 1 ulp; -infinity of 0.
double log_of(double x);
/// Domain: x > 0. Returns: within 1 ulp.
double log2_of(double x);

/// Domain: degrees, |x| < 1e9. Returns: exact at multiples of 90 degrees, else within 2 ulp.
double sin_degrees(double degrees);
double cos_degrees(double degrees);

}  // namespace tia
