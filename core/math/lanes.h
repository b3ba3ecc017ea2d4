// The lanes of a scalar one by one, and the scalar in double, in integers and back.
#pragma once

#include <bit>
#include <cstring>

#include "core/math/wide.h"

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace tia {

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
inline float lane(const FloatRegister& value, int lane) {
  return value.get(static_cast<std::size_t>(lane));
}
template <class Register, std::size_t N>
typename Register::value_type lane(const Registers<Register, N>& value, int lane) {
  typename Register::value_type one;
  static_assert(sizeof value == sizeof one * Registers<Register, N>::size);
  std::memcpy(&one, reinterpret_cast<const char*>(&value) + sizeof one * std::size_t(lane),
              sizeof one);
  return one;
}
inline void set_lane(float& value, int, float one) { value = one; }
inline void set_lane(double& value, int, double one) { value = one; }
inline void set_lane(Wide& value, int lane, float one) {
  std::memcpy(reinterpret_cast<char*>(&value) + sizeof one * std::size_t(lane), &one, sizeof one);
}
/// Sets a lane to a number, or a triple, of the compiled scene as lift() has it.
template <class Real>
void put_lane(Real& to, int lane, double value) {
  set_lane(to, lane, static_cast<LaneOf<Real>>(value));
}
template <class Real>
void put_lane(Vec3<Real>& to, int lane, const Vec3d& value) {
  put_lane(to.x, lane, value.x), put_lane(to.y, lane, value.y), put_lane(to.z, lane, value.z);
}

/// Calls f(lane) for each lane of the mask, one by one.
template <class M, class F>
[[gnu::always_inline]] inline void for_each_lane(const M& here, F f) {
  for (unsigned left = bits(here); left != 0; left &= left - 1) f(std::countr_zero(left));
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

/// Rounds to nearest. Results that are computed in double become Real here, and nowhere else.
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
