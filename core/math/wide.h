// One text, three scalars: what formulas need so that they read the same for float, double and
// Wide, two of the processor's float registers. Only IEEE + - * / sqrt, comparisons and selections:
// a lane of Wide equals float bit for bit. No fused or estimated operations here.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

#include "core/math/registers.h"
#include "core/math/vec3.h"

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace tia {

/// Wide: the picture's float lanes (16 with AVX2, 8 with SSE2). How many there are never changes a
/// result; two registers measured better than one and four.
using Wide = Registers<FloatRegister, 2>;
using WideMask = Registers<FloatRegister::batch_bool_type, 2>;
using WideInt = Registers<xsimd::batch<std::int32_t, Isa>, 2>;
/// WideDouble: the lanes of a Wide in double.
using WideDouble = Registers<Registers<DoubleRegister, 2>, 2>;
static_assert(Wide::size == WideInt::size && Wide::size == WideDouble::size);

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
/// One register: what one ray is tried on at once.
template <>
struct ScalarTraits<FloatRegister> {
  using Mask = FloatRegister::batch_bool_type;
  using Precise = Registers<DoubleRegister, 2>;
  static constexpr int lanes = static_cast<int>(FloatRegister::size);
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

/// Constant: a triple of the compiled scene, rounded once instead of at every ray that meets it.
struct Constant {
  Vec3d exact{};
  Vec3f rounded{};

  Constant() = default;
  Constant(const Vec3d& v) : exact(v), rounded(lift<float>(v)) {}
  bool operator==(const Constant&) const = default;
};
template <class Real>
Vec3<Real> lift(const Constant& c) {
  return static_cast<Vec3<Real>>(c.rounded);
}
template <>
inline Vec3d lift<double>(const Constant& c) {
  return c.exact;
}

// ---- selection: mask ? a : b, lane by lane ------------------------------------------------

inline float select(bool mask, float a, float b) { return mask ? a : b; }
inline double select(bool mask, double a, double b) { return mask ? a : b; }
[[gnu::always_inline]] inline FloatRegister select(const FloatRegister::batch_bool_type& mask,
                                                   const FloatRegister& a, const FloatRegister& b) {
  return xsimd::select(mask, a, b);
}
[[gnu::always_inline]] inline Wide select(const WideMask& mask, const Wide& a, const Wide& b) {
  return Wide::map(
      [](const auto& m, const auto& x, const auto& y) { return xsimd::select(m, x, y); }, mask, a,
      b);
}
template <class Real>
[[gnu::always_inline]] inline Vec3<Real> select(const Mask<Real>& mask, const Vec3<Real>& a,
                                                const Vec3<Real>& b) {
  return {select(mask, a.x, b.x), select(mask, a.y, b.y), select(mask, a.z, b.z)};
}

/// The larger and the smaller of two numbers; the second where they do not compare (NaN).
template <class Real>
[[gnu::always_inline]] inline Real max_of(Real a, Real b) {
  return select(a > b, a, b);
}
template <class Real>
[[gnu::always_inline]] inline Real min_of(Real a, Real b) {
  return select(a < b, a, b);
}
#if defined(__SSE2__)  // where maxps and minps are defined just so
template <>
[[gnu::always_inline]] inline Wide max_of(Wide a, Wide b) {
  return Wide::map([](const auto& x, const auto& y) { return xsimd::max(x, y); }, a, b);
}
template <>
[[gnu::always_inline]] inline Wide min_of(Wide a, Wide b) {
  return Wide::map([](const auto& x, const auto& y) { return xsimd::min(x, y); }, a, b);
}
template <>
[[gnu::always_inline]] inline FloatRegister max_of(FloatRegister a, FloatRegister b) {
  return xsimd::max(a, b);
}
template <>
[[gnu::always_inline]] inline FloatRegister min_of(FloatRegister a, FloatRegister b) {
  return xsimd::min(a, b);
}
#endif
inline float abs_of(float a) { return std::fabs(a); }
inline double abs_of(double a) { return std::fabs(a); }
inline FloatRegister abs_of(const FloatRegister& a) { return xsimd::abs(a); }
template <class Register, std::size_t N>
[[gnu::always_inline]] inline Registers<Register, N> abs_of(const Registers<Register, N>& a) {
  return Registers<Register, N>::map(
      [](const auto& x) {
        using xsimd::abs;
        if constexpr (requires { x.part; }) return abs_of(x);
        else return abs(x);
      },
      a);
}
[[gnu::always_inline]] inline Wide abs_of(const Wide& a) {
  return Wide::map([](const FloatRegister& x) { return xsimd::abs(x); }, a);
}

// ---- masks --------------------------------------------------------------------------------

/// The mask as bits, lane 0 lowest.
inline unsigned bits(bool mask) { return mask ? 1U : 0U; }
inline unsigned bits(const FloatRegister::batch_bool_type& mask) {
#if defined(__AVX__)
  return static_cast<unsigned>(_mm256_movemask_ps(mask));
#elif defined(__SSE2__)
  return static_cast<unsigned>(_mm_movemask_ps(mask));
#else
  bool each[FloatRegister::size];
  mask.store_unaligned(each);
  unsigned all = 0;
  for (unsigned i = 0; i < FloatRegister::size; ++i) all |= unsigned(each[i]) << i;
  return all;
#endif
}
[[gnu::always_inline]] inline unsigned bits(const WideMask& mask) {
  return bits(mask.part[0]) | bits(mask.part[1]) << FloatRegister::size;
}
inline bool any(bool mask) { return mask; }
inline bool any(const FloatRegister::batch_bool_type& mask) { return bits(mask) != 0; }
[[gnu::always_inline]] inline bool any(const WideMask& mask) {
  return bits(mask.part[0] | mask.part[1]) != 0;
}
template <class M>
int count(const M& mask) {
  return std::popcount(bits(mask));
}

/// The greatest lane.
inline float greatest_lane(const FloatRegister& value) {
#if defined(__SSE2__)
#if defined(__AVX__)
  const __m256 all = value;
  __m128 most = _mm_max_ps(_mm256_castps256_ps128(all), _mm256_extractf128_ps(all, 1));
#else
  __m128 most = value;
#endif
  most = _mm_max_ps(most, _mm_movehl_ps(most, most));
  return _mm_cvtss_f32(_mm_max_ss(most, _mm_shuffle_ps(most, most, 1)));
#else
  float each[FloatRegister::size];
  value.store_unaligned(each);
  float most = each[0];
  for (const float one : each) most = one > most ? one : most;
  return most;
#endif
}

// ---- lanes --------------------------------------------------------------------------------

/// 0, 1, 2 … across the lanes.
template <class Real>
Real iota() {
  return Real(0);
}
template <>
inline Wide iota<Wide>() {
  float index[Wide::size];
  for (std::size_t i = 0; i < Wide::size; ++i) index[i] = static_cast<float>(i);
  return Wide::load_unaligned(index);
}

inline void store(float value, float* to) { *to = value; }
inline void store(double value, float* to) { *to = static_cast<float>(value); }
inline void store(const Wide& value, float* to) { value.store_unaligned(to); }

inline void store(double value, double* to) { *to = value; }
inline void store(const WideDouble& value, double* to) { value.store_unaligned(to); }

/// What a lane holds, and all lanes from an array of it.
template <class Real>
using LaneOf = std::conditional_t<std::is_same_v<Real, double> || std::is_same_v<Real, WideDouble>,
                                  double, float>;
template <class Real>
Real load(const LaneOf<Real>* from) {
  return *from;
}
template <>
inline Wide load<Wide>(const float* from) {
  return Wide::load_unaligned(from);
}
template <>
inline WideDouble load<WideDouble>(const double* from) {
  return WideDouble::load_unaligned(from);
}

/// One lane's value. Domain: 0 <= lane < lanes.
inline float lane(float value, int) { return value; }
inline double lane(double value, int) { return value; }
template <class Register, std::size_t N>
typename Register::value_type lane(const Registers<Register, N>& value, int lane) {
  typename Register::value_type one;
  static_assert(sizeof value == sizeof one * Registers<Register, N>::size);
  std::memcpy(&one, reinterpret_cast<const char*>(&value) + sizeof one * std::size_t(lane),
              sizeof one);
  return one;
}
inline void set_lane(Wide& value, int lane, float one) {
  std::memcpy(reinterpret_cast<char*>(&value) + sizeof one * std::size_t(lane), &one, sizeof one);
}

// ---- to double, to integers, and back -----------------------------------------------------

inline double widen(float value) { return value; }
inline double widen(double value) { return value; }
[[gnu::always_inline]] inline Registers<DoubleRegister, 2> widen(const FloatRegister& value) {
  Registers<DoubleRegister, 2> r;
#if defined(__AVX__)
  const __m256 v = value;
  r.part[0] = _mm256_cvtps_pd(_mm256_castps256_ps128(v));
  r.part[1] = _mm256_cvtps_pd(_mm256_extractf128_ps(v, 1));
#elif defined(__SSE2__)
  const __m128 v = value;
  r.part[0] = _mm_cvtps_pd(v);
  r.part[1] = _mm_cvtps_pd(_mm_movehl_ps(v, v));
#else
  float each[FloatRegister::size];
  double doubles[FloatRegister::size];
  value.store_unaligned(each);
  for (std::size_t i = 0; i < FloatRegister::size; ++i) doubles[i] = each[i];
  r = Registers<DoubleRegister, 2>::load_unaligned(doubles);
#endif
  return r;
}
[[gnu::always_inline]] inline WideDouble widen(const Wide& value) {
  return WideDouble::map([](const FloatRegister& x) { return widen(x); }, value);
}
template <class Real>
[[gnu::always_inline]] inline Vec3<Precise<Real>> widen(const Vec3<Real>& v) {
  return {widen(v.x), widen(v.y), widen(v.z)};
}

/// Rounds to nearest: the door through which a root computed in double leaves.
template <class Real>
Real narrow(double value) {
  return static_cast<Real>(value);
}
[[gnu::always_inline]] inline FloatRegister narrow(const Registers<DoubleRegister, 2>& value) {
#if defined(__AVX__)
  return _mm256_set_m128(_mm256_cvtpd_ps(value.part[1]), _mm256_cvtpd_ps(value.part[0]));
#elif defined(__SSE2__)
  return _mm_movelh_ps(_mm_cvtpd_ps(value.part[0]), _mm_cvtpd_ps(value.part[1]));
#else
  double doubles[FloatRegister::size];
  float each[FloatRegister::size];
  value.store_unaligned(doubles);
  for (std::size_t i = 0; i < FloatRegister::size; ++i) each[i] = static_cast<float>(doubles[i]);
  return FloatRegister::load_unaligned(each);
#endif
}
template <class Real>
[[gnu::always_inline]] inline FloatRegister narrow(const Registers<DoubleRegister, 2>& value) {
  return narrow(value);
}
template <class Real>
[[gnu::always_inline]] inline Wide narrow(const WideDouble& value) {
  return Wide::map([](const auto& x) { return narrow(x); }, value);
}

/// Towards zero. Domain: -2^31 <= value < 2^31.
inline WideInt to_int(const Wide& value) {
  return WideInt::map([](const FloatRegister& x) { return xsimd::to_int(x); }, value);
}

}  // namespace tia
