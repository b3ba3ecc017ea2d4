// SLEEF's functions by the names that they have for this processor's registers. Its "cinz" variants
// are the same arithmetic, without fused operations, in every width and on every processor.
// For the files that call SLEEF only: these are macros.
#pragma once

#include <sleef.h>

#if defined(__AVX__)
#define TIA_SLEEF_FLOATS(name) Sleef_cinz_##name##f8_u10avx
#define TIA_SLEEF_DOUBLES(name, ulps) Sleef_cinz_##name##d4_##ulps##avx
#elif defined(__SSE2__)
#define TIA_SLEEF_FLOATS(name) Sleef_cinz_##name##f4_u10sse2
#define TIA_SLEEF_DOUBLES(name, ulps) Sleef_cinz_##name##d2_##ulps##sse2
#elif defined(__aarch64__)
#define TIA_SLEEF_FLOATS(name) Sleef_cinz_##name##f4_u10advsimdnofma
#define TIA_SLEEF_DOUBLES(name, ulps) Sleef_cinz_##name##d2_##ulps##advsimdnofma
#else
#error "How SLEEF names its functions for this processor's registers must be said here"
#endif
