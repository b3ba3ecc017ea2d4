#include "core/math/octet.h"

#include <sleef.h>

#include "core/math/deterministic.h"
#include "core/math/powers.h"

namespace tia {
namespace {

using R = DoubleRegister;

template <class F>
Octet each_register(F f, const Octet& x) {
  return Octet::map([&](const R& v) { return R(f(v)); }, x);
}
template <class F>
Octet each_register(F f, const Octet& x, const Octet& y) {
  return Octet::map([&](const R& v, const R& w) { return R(f(v, w)); }, x, y);
}
#if !defined(__SSE2__)
template <class F, class... X>
Octet each_lane(F f, const X&... x) {
  double to[Octet::size];
  for (std::size_t i = 0; i < Octet::size; ++i) to[i] = f(lane(x, static_cast<int>(i))...);
  return Octet::load_unaligned(to);
}
#endif

}  // namespace

// SLEEF names its functions by register; each is the same arithmetic in every width.
#if defined(__AVX__)
#define TIA_SLEEF(name) Sleef_cinz_##name##d4_u10avx
#define TIA_SLEEF_SINCOS Sleef_cinz_sincosd4_u35avx
#elif defined(__SSE2__)
#define TIA_SLEEF(name) Sleef_cinz_##name##d2_u10sse2
#define TIA_SLEEF_SINCOS Sleef_cinz_sincosd2_u35sse2
#endif

#if defined(TIA_SLEEF)
SineCosine<Octet> sincos_of(const Octet& x) {
  SineCosine<Octet> both;
  for (std::size_t i = 0; i < Octet::size / R::size; ++i) {
    const auto own = TIA_SLEEF_SINCOS(x.part[i]);
    both.sine.part[i] = own.x;
    both.cosine.part[i] = own.y;
  }
  return both;
}
Octet tan_of(const Octet& x) { return each_register(TIA_SLEEF(tan), x); }
Octet asin_of(const Octet& x) { return each_register(TIA_SLEEF(asin), x); }
Octet acos_of(const Octet& x) { return each_register(TIA_SLEEF(acos), x); }
Octet atan_of(const Octet& x) { return each_register(TIA_SLEEF(atan), x); }
Octet atan2_of(const Octet& y, const Octet& x) { return each_register(TIA_SLEEF(atan2), y, x); }
Octet sinh_of(const Octet& x) { return each_register(TIA_SLEEF(sinh), x); }
Octet cosh_of(const Octet& x) { return each_register(TIA_SLEEF(cosh), x); }
Octet tanh_of(const Octet& x) { return each_register(TIA_SLEEF(tanh), x); }
Octet exp_of(const Octet& x) { return each_register(TIA_SLEEF(exp), x); }
Octet log_of(const Octet& x) { return each_register(TIA_SLEEF(log), x); }
Octet pow_of(const Octet& base, const Octet& exponent) {
  return each_register(TIA_SLEEF(pow), base, exponent);
}
#undef TIA_SLEEF
#undef TIA_SLEEF_SINCOS
#else
Octet sin_of(const Octet& x) {
  return each_lane([](double v) { return sin_of(v); }, x);
}
Octet cos_of(const Octet& x) {
  return each_lane([](double v) { return cos_of(v); }, x);
}
Octet tan_of(const Octet& x) {
  return each_lane([](double v) { return tan_of(v); }, x);
}
Octet asin_of(const Octet& x) {
  return each_lane([](double v) { return asin_of(v); }, x);
}
Octet acos_of(const Octet& x) {
  return each_lane([](double v) { return acos_of(v); }, x);
}
Octet atan_of(const Octet& x) {
  return each_lane([](double v) { return atan_of(v); }, x);
}
Octet atan2_of(const Octet& y, const Octet& x) {
  return each_lane([](double v, double w) { return atan2_of(v, w); }, y, x);
}
Octet sinh_of(const Octet& x) {
  return each_lane([](double v) { return sinh_of(v); }, x);
}
Octet cosh_of(const Octet& x) {
  return each_lane([](double v) { return cosh_of(v); }, x);
}
Octet tanh_of(const Octet& x) {
  return each_lane([](double v) { return tanh_of(v); }, x);
}
Octet exp_of(const Octet& x) {
  return each_lane([](double v) { return exp_of(v); }, x);
}
Octet log_of(const Octet& x) {
  return each_lane([](double v) { return log_of(v); }, x);
}
Octet pow_of(const Octet& base, const Octet& exponent) {
  return each_lane([](double v, double w) { return pow_of(v, w); }, base, exponent);
}
#endif

}  // namespace tia
