#include "core/math/powers.h"

#include <sleef.h>

namespace tia {
namespace {

#if defined(__AVX__)
FloatRegister powers(const FloatRegister& a, const FloatRegister& b) {
  return Sleef_cinz_powf8_u10avx(a, b);
}
FloatRegister exponentials(const FloatRegister& x) { return Sleef_cinz_expf8_u10avx(x); }
#elif defined(__SSE2__)
FloatRegister powers(const FloatRegister& a, const FloatRegister& b) {
  return Sleef_cinz_powf4_u10sse2(a, b);
}
FloatRegister exponentials(const FloatRegister& x) { return Sleef_cinz_expf4_u10sse2(x); }
#else
template <class F>
FloatRegister each_of(F f) {
  float each[FloatRegister::size];
  for (std::size_t i = 0; i < FloatRegister::size; ++i) each[i] = f(i);
  return FloatRegister::load_unaligned(each);
}
FloatRegister powers(const FloatRegister& a, const FloatRegister& b) {
  return each_of([&](std::size_t i) { return pow_of(a.get(i), b.get(i)); });
}
FloatRegister exponentials(const FloatRegister& x) {
  return each_of([&](std::size_t i) { return exp_of(x.get(i)); });
}
#endif

}  // namespace

float pow_of(float base, float exponent) { return Sleef_cinz_powf1_u10purec(base, exponent); }
double pow_of(double base, double exponent) { return Sleef_cinz_powd1_u10purec(base, exponent); }
Wide pow_of(const Wide& base, const Wide& exponent) { return Wide::map(powers, base, exponent); }

float exp_of(float x) { return Sleef_cinz_expf1_u10purec(x); }
double exp_of(double x) { return Sleef_cinz_expd1_u10purec(x); }
Wide exp_of(const Wide& x) { return Wide::map(exponentials, x); }

}  // namespace tia
