// Octet: eight doubles that are computed together; what formulas need so that they read the same
// for one double and for eight. How many registers they take never changes a result.
#pragma once

#include "core/math/deterministic.h"
#include "core/math/lanes.h"

namespace tia {

using Octet = Registers<DoubleRegister, 8 / DoubleRegister::size>;
using OctetMask =
    Registers<DoubleRegister::batch_bool_type, 8 / DoubleRegister::batch_bool_type::size>;
static_assert(Octet::size == 8);

template <>
struct ScalarTraits<Octet> {
  using Mask = OctetMask;
  using Precise = Octet;
  static constexpr int lanes = 8;
};

[[gnu::always_inline]] inline Octet select(const OctetMask& mask, const Octet& a, const Octet& b) {
  return Octet::map(
      [](const auto& m, const auto& x, const auto& y) { return xsimd::select(m, x, y); }, mask, a,
      b);
}
#if defined(__SSE2__)  // where maxpd and minpd are defined as max_of and min_of are
template <>
[[gnu::always_inline]] inline Octet max_of(Octet a, Octet b) {
  return Octet::map([](const auto& x, const auto& y) { return xsimd::max(x, y); }, a, b);
}
template <>
[[gnu::always_inline]] inline Octet min_of(Octet a, Octet b) {
  return Octet::map([](const auto& x, const auto& y) { return xsimd::min(x, y); }, a, b);
}
#endif

inline double floor_of(double x) { return std::floor(x); }
inline Octet floor_of(const Octet& x) {
#if !defined(__SSE4_1__)  // where it is made of integers, which have no -0
  return Octet::map(
      [](const DoubleRegister& each) { return xsimd::floor(each) | xsimd::bitofsign(each); }, x);
#else
  return Octet::map([](const DoubleRegister& each) { return xsimd::floor(each); }, x);
#endif
}

/// The mask as bits, lane 0 lowest.
inline unsigned bits(const OctetMask& mask) {
  unsigned all = 0;
  for (unsigned i = 0; i < Octet::size / DoubleRegister::size; ++i) {
#if defined(__AVX__)
    all |= static_cast<unsigned>(_mm256_movemask_pd(mask.part[i])) << i * DoubleRegister::size;
#elif defined(__SSE2__)
    all |= static_cast<unsigned>(_mm_movemask_pd(mask.part[i])) << i * DoubleRegister::size;
#else
    bool each[DoubleRegister::size];
    mask.part[i].store_unaligned(each);
    for (unsigned k = 0; k < DoubleRegister::size; ++k)
      all |= unsigned(each[k]) << (i * DoubleRegister::size + k);
#endif
  }
  return all;
}

inline bool any(const OctetMask& mask) { return bits(mask) != 0; }

/// The mask of the lanes that are set in the bits.
inline OctetMask mask_of(unsigned lanes) {
  double each[Octet::size];
  for (unsigned i = 0; i < Octet::size; ++i) each[i] = (lanes >> i & 1) != 0 ? 1 : 0;
  return Octet::load_unaligned(each) > Octet(0.0);
}

// ---- the functions of formulas, lane by lane the same bits as deterministic.h's and powers.h's --

SineCosine<Octet> sincos_of(const Octet& x);
Octet tan_of(const Octet& x);
Octet asin_of(const Octet& x);
Octet acos_of(const Octet& x);
Octet atan_of(const Octet& x);
Octet atan2_of(const Octet& y, const Octet& x);
Octet sinh_of(const Octet& x);
Octet cosh_of(const Octet& x);
Octet tanh_of(const Octet& x);
Octet exp_of(const Octet& x);
Octet log_of(const Octet& x);
Octet pow_of(const Octet& base, const Octet& exponent);

}  // namespace tia
