#include "core/math/powers.h"

#include "core/math/sleef_names.h"

namespace tia {
namespace {

FloatRegister powers(const FloatRegister& a, const FloatRegister& b) {
  return TIA_SLEEF_FLOATS(pow)(a, b);
}
FloatRegister exponentials(const FloatRegister& x) { return TIA_SLEEF_FLOATS(exp)(x); }

}  // namespace

float pow_of(float base, float exponent) { return Sleef_cinz_powf1_u10purec(base, exponent); }
double pow_of(double base, double exponent) { return Sleef_cinz_powd1_u10purec(base, exponent); }
Wide pow_of(const Wide& base, const Wide& exponent) { return Wide::map(powers, base, exponent); }

float exp_of(float x) { return Sleef_cinz_expf1_u10purec(x); }
double exp_of(double x) { return Sleef_cinz_expd1_u10purec(x); }
Wide exp_of(const Wide& x) { return Wide::map(exponentials, x); }

}  // namespace tia
