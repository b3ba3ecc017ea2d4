// Functions beyond + - * / sqrt, the same bits on every processor. They come from SLEEF's
// deterministic, FMA-free scalar variants, never from libm, whose variants the processor picks.
#pragma once

namespace tia {

inline constexpr double pi = 3.14159265358979323846;

/// Domain: radians, |x| < 1e14. Returns: tan x within 1 ulp.
double tan_of(double radians);

}  // namespace tia
