#include "core/math/deterministic.h"

#include <sleef.h>

namespace tia {

double tan_of(double radians) { return Sleef_cinz_tand1_u10purec(radians); }

}  // namespace tia
