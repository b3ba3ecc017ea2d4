#include "core/math/deterministic.h"

#include <cmath>

#include <sleef.h>

namespace tia {

double tan_of(double radians) { return Sleef_cinz_tand1_u10purec(radians); }
double sin_of(double radians) { return Sleef_cinz_sind1_u10purec(radians); }
double cos_of(double radians) { return Sleef_cinz_cosd1_u10purec(radians); }
SineCosine<double> sincos_of(double radians) {
  const auto both = Sleef_cinz_sincosd1_u35purec(radians);
  return {both.x, both.y};
}
double atan2_of(double y, double x) { return Sleef_cinz_atan2d1_u10purec(y, x); }
double atan_of(double x) { return Sleef_cinz_atand1_u10purec(x); }
double asin_of(double x) { return Sleef_cinz_asind1_u10purec(x); }
double acos_of(double x) { return Sleef_cinz_acosd1_u10purec(x); }
double sinh_of(double x) { return Sleef_cinz_sinhd1_u10purec(x); }
double cosh_of(double x) { return Sleef_cinz_coshd1_u10purec(x); }
double tanh_of(double x) { return Sleef_cinz_tanhd1_u10purec(x); }
double log_of(double x) { return Sleef_cinz_logd1_u10purec(x); }
double log2_of(double x) { return Sleef_cinz_log2d1_u10purec(x); }

// The rest to the nearest quarter turn is exact (fmod and the subtraction of nearby numbers are).
double sin_degrees(double degrees) {
  const double turned = std::fmod(degrees, 360.0);
  const double quarters = std::nearbyint(turned / 90);
  const double rest = (turned - quarters * 90) * (pi / 180);
  switch ((static_cast<int>(quarters) + 8) % 4) {
    case 0: return sin_of(rest);
    case 1: return cos_of(rest);
    case 2: return -sin_of(rest);
    default: return -cos_of(rest);
  }
}

double cos_degrees(double degrees) { return sin_degrees(std::fmod(degrees, 360.0) + 90); }

}  // namespace tia
