// One text, three scalars: what formulas need so that they read the same for float, double and
// Wide, the processor's float lanes (8 with AVX2, 4 with SSE2). Only IEEE + - * / sqrt, comparisons
// and selections: a lane of Wide equals float bit for bit. No fused or estimated operations here.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include <xsimd/xsimd.hpp>

#include "core/math/vec3.h"

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace tia {

/// Wide: a register of float lanes. How many there are never changes a result.
using Wide = xsimd::batch<float>;
using WideMask = xsimd::batch_bool<float>;

/// WideDouble: the lanes of a Wide in double, as two half registers.
struct WideDouble {
  using Half = xsimd::batch<double>;
  Half lo, hi;

  WideDouble() = default;
  WideDouble(double all) : lo(all), hi(all) {}
  WideDouble(Half l, Half h) : lo(l), hi(h) {}

  friend WideDouble operator+(WideDouble a, WideDouble b) { return {a.lo + b.lo, a.hi + b.hi}; }
  friend WideDouble operator-(WideDouble a, WideDouble b) { return {a.lo - b.lo, a.hi - b.hi}; }
  friend WideDouble operator*(WideDouble a, WideDouble b) { return {a.lo * b.lo, a.hi * b.hi}; }
  friend WideDouble sqrt(WideDouble a) { return {xsimd::sqrt(a.lo), xsimd::sqrt(a.hi)}; }
};
static_assert(Wide::size == 2 * WideDouble::Half::size);

/// What goes with a scalar: how many lanes, what a comparison gives, and the double-precision
/// companion in which delicate roots are computed.
template <class Real>
struct ScalarTraits {
  using Mask = bool;
  using Precise = double;
  static constexpr int lanes = 1;
};
template <>
struct ScalarTraits<Wide> {
  using Mask = WideMask;
  using Precise = WideDouble;
  static constexpr int lanes = static_cast<int>(Wide::size);
};
template <class Real>
using Mask = typename ScalarTraits<Real>::Mask;
template <class Real>
using Precise = typename ScalarTraits<Real>::Precise;
template <class Real>
inline constexpr int lanes = ScalarTraits<Real>::lanes;

inline constexpr float infinity = std::numeric_limits<float>::infinity();

/// Turns a double of the scene into the scalar of the picture: rounded once, to float, unless the
/// scalar is double.
template <class Real>
Real lift(double value) {
  return Real(static_cast<float>(value));
}
template <>
inline double lift<double>(double value) {
  return value;
}
template <class Real>
Vec3<Real> lift(const Vec3d& v) {
  return {lift<Real>(v.x), lift<Real>(v.y), lift<Real>(v.z)};
}

// ---- selection: mask ? a : b, lane by lane ------------------------------------------------

inline float select(bool mask, float a, float b) { return mask ? a : b; }
inline double select(bool mask, double a, double b) { return mask ? a : b; }
inline Wide select(WideMask mask, Wide a, Wide b) { return xsimd::select(mask, a, b); }
template <class Real>
Vec3<Real> select(Mask<Real> mask, const Vec3<Real>& a, const Vec3<Real>& b) {
  return {select(mask, a.x, b.x), select(mask, a.y, b.y), select(mask, a.z, b.z)};
}

/// The larger of two ordered numbers; the second where they do not compare (NaN).
template <class Real>
Real max_of(Real a, Real b) {
  return select(a > b, a, b);
}
inline float abs_of(float a) { return std::fabs(a); }
inline double abs_of(double a) { return std::fabs(a); }
inline Wide abs_of(Wide a) { return xsimd::abs(a); }

// ---- masks --------------------------------------------------------------------------------

/// The mask as bits, lane 0 lowest.
inline unsigned bits(bool mask) { return mask ? 1U : 0U; }
inline unsigned bits(WideMask mask) {
#if defined(__AVX__)
  return static_cast<unsigned>(_mm256_movemask_ps(mask));
#elif defined(__SSE2__)
  return static_cast<unsigned>(_mm_movemask_ps(mask));
#else
  bool each[WideMask::size];
  mask.store_unaligned(each);
  unsigned all = 0;
  for (unsigned i = 0; i < WideMask::size; ++i) all |= unsigned(each[i]) << i;
  return all;
#endif
}
template <class M>
bool any(M mask) {
  return bits(mask) != 0;
}
template <class M>
int count(M mask) {
  return std::popcount(bits(mask));
}

// ---- lanes --------------------------------------------------------------------------------

/// 0, 1, 2 … across the lanes.
template <class Real>
Real iota() {
  return Real(0);
}
template <>
inline Wide iota<Wide>() {
  alignas(32) float index[Wide::size];
  for (std::size_t i = 0; i < Wide::size; ++i) index[i] = static_cast<float>(i);
  return Wide::load_aligned(index);
}

inline void store(float value, float* to) { *to = value; }
inline void store(double value, float* to) { *to = static_cast<float>(value); }
inline void store(Wide value, float* to) { value.store_unaligned(to); }

/// One lane's value. Domain: 0 <= lane < lanes.
inline float lane(float value, int) { return value; }
inline double lane(double value, int) { return value; }
inline float lane(Wide value, int lane) {
  alignas(32) float each[Wide::size];
  value.store_aligned(each);
  return each[lane];
}

// ---- to double and back -------------------------------------------------------------------

inline double widen(float value) { return value; }
inline double widen(double value) { return value; }
inline WideDouble widen(Wide value) {
#if defined(__AVX__)
  const __m256 v = value;
  return {_mm256_cvtps_pd(_mm256_castps256_ps128(v)), _mm256_cvtps_pd(_mm256_extractf128_ps(v, 1))};
#elif defined(__SSE2__)
  const __m128 v = value;
  return {_mm_cvtps_pd(v), _mm_cvtps_pd(_mm_movehl_ps(v, v))};
#else
  float each[Wide::size];
  double doubles[Wide::size];
  value.store_unaligned(each);
  for (std::size_t i = 0; i < Wide::size; ++i) doubles[i] = each[i];
  return {WideDouble::Half::load_unaligned(doubles),
          WideDouble::Half::load_unaligned(doubles + WideDouble::Half::size)};
#endif
}
template <class Real>
Vec3<Precise<Real>> widen(const Vec3<Real>& v) {
  return {widen(v.x), widen(v.y), widen(v.z)};
}

/// Rounds to nearest: the door through which a root computed in double leaves.
template <class Real>
Real narrow(double value) {
  return static_cast<Real>(value);
}
template <class Real>
Wide narrow(WideDouble value) {
#if defined(__AVX__)
  return _mm256_set_m128(_mm256_cvtpd_ps(value.hi), _mm256_cvtpd_ps(value.lo));
#elif defined(__SSE2__)
  return _mm_movelh_ps(_mm_cvtpd_ps(value.lo), _mm_cvtpd_ps(value.hi));
#else
  double doubles[Wide::size];
  float each[Wide::size];
  value.lo.store_unaligned(doubles);
  value.hi.store_unaligned(doubles + WideDouble::Half::size);
  for (std::size_t i = 0; i < Wide::size; ++i) each[i] = static_cast<float>(doubles[i]);
  return Wide::load_unaligned(each);
#endif
}

}  // namespace tia
