// Powers and exponentials of a picture's scalars, the same bits in every width and on every
// processor (SLEEF's deterministic, FMA-free variants).
#pragma once

#include "core/math/wide.h"

namespace tia {

/// base^exponent within 1 ulp. Domain: base >= 0.
float pow_of(float base, float exponent);
double pow_of(double base, double exponent);
Wide pow_of(const Wide& base, const Wide& exponent);

/// e^x within 1 ulp; 0 for -infinity.
float exp_of(float x);
double exp_of(double x);
Wide exp_of(const Wide& x);

}  // namespace tia
