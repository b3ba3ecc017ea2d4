#include "core/math/octet.h"

#include "core/math/sleef_names.h"

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

}  // namespace

SineCosine<Octet> sincos_of(const Octet& x) {
  SineCosine<Octet> both;
  for (std::size_t i = 0; i < Octet::size / R::size; ++i) {
    const auto own = TIA_SLEEF_DOUBLES(sincos, u35)(x.part[i]);
    both.sine.part[i] = R(own.x);
    both.cosine.part[i] = R(own.y);
  }
  return both;
}
Octet tan_of(const Octet& x) { return each_register(TIA_SLEEF_DOUBLES(tan, u10), x); }
Octet asin_of(const Octet& x) { return each_register(TIA_SLEEF_DOUBLES(asin, u10), x); }
Octet acos_of(const Octet& x) { return each_register(TIA_SLEEF_DOUBLES(acos, u10), x); }
Octet atan_of(const Octet& x) { return each_register(TIA_SLEEF_DOUBLES(atan, u10), x); }
Octet sinh_of(const Octet& x) { return each_register(TIA_SLEEF_DOUBLES(sinh, u10), x); }
Octet cosh_of(const Octet& x) { return each_register(TIA_SLEEF_DOUBLES(cosh, u10), x); }
Octet tanh_of(const Octet& x) { return each_register(TIA_SLEEF_DOUBLES(tanh, u10), x); }
Octet exp_of(const Octet& x) { return each_register(TIA_SLEEF_DOUBLES(exp, u10), x); }
Octet log_of(const Octet& x) { return each_register(TIA_SLEEF_DOUBLES(log, u10), x); }
Octet atan2_of(const Octet& y, const Octet& x) {
  return each_register(TIA_SLEEF_DOUBLES(atan2, u10), y, x);
}
Octet pow_of(const Octet& base, const Octet& exponent) {
  return each_register(TIA_SLEEF_DOUBLES(pow, u10), base, exponent);
}

}  // namespace tia
