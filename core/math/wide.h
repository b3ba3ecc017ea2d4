// One text, three scalars: what formulas need so that they read the same for float, double and
// Wide, two of the processor's float registers. Only IEEE + - * / sqrt, comparisons and selections:
// a lane of Wide equals float bit for bit. No fused or estimated operations here.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
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
/// FloatRegister: one register, for as many things as one ray is tried on at once.
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
inline DoubleRegister abs_of(const DoubleRegister& a) { return xsimd::abs(a); }
template <class Register, std::size_t N>
[[gnu::always_inline]] inline Registers<Register, N> abs_of(const Registers<Register, N>& a) {
  return Registers<Register, N>::map([](const auto& x) { return abs_of(x); }, a);
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

}  // namespace tia
