// Several of the processor's vector registers that act as one.
#pragma once

#include <cstddef>
#include <functional>

#include <xsimd/xsimd.hpp>

#if defined(__aarch64__)
// xsimd estimates float quotients and roots, as processors before these had to. These have IEEE's.
namespace xsimd::kernel {
template <>
inline batch<float, neon64> div<neon64>(const batch<float, neon64>& a,
                                        const batch<float, neon64>& b,
                                        requires_arch<neon>) noexcept {
  return vdivq_f32(a, b);
}
template <>
inline batch<float, neon64> sqrt<neon64>(const batch<float, neon64>& a,
                                         requires_arch<neon>) noexcept {
  return vsqrtq_f32(a);
}
}  // namespace xsimd::kernel
#endif

namespace tia {

#if defined(__AVX2__)
using Isa = xsimd::avx2;  // and no wider where the processor is
#else
using Isa = xsimd::default_arch;
#endif
using FloatRegister = xsimd::batch<float, Isa>;
using DoubleRegister = xsimd::batch<double, Isa>;

/// Where a mask is not set. xsimd's own ! compares with false, which AVX2 does by halves.
inline bool opposite(bool mask) { return !mask; }
template <class T, class Arch>
xsimd::batch_bool<T, Arch> opposite(const xsimd::batch_bool<T, Arch>& mask) {
  return ~mask;
}

/// Registers: N registers that do everything together. A pixel is one long chain of roots and
/// quotients: while one register waits for its next, another computes.
template <class Register, std::size_t N>
struct Registers {
  using value_type = typename Register::value_type;
  static constexpr std::size_t size = N * Register::size;
  Register part[N];

  Registers() = default;
  Registers(value_type all) {
    for (Register& each : part) each = Register(all);
  }
  /// Of its parts, one by one.
  template <class... Parts>
  static Registers of(const Parts&... parts) {
    static_assert(sizeof...(Parts) == N);
    Registers r;
    std::size_t i = 0;
    ((r.part[i++] = parts), ...);
    return r;
  }
  static Registers load_unaligned(const value_type* from) {
    Registers r;
    for (std::size_t i = 0; i < N; ++i)
      r.part[i] = Register::load_unaligned(from + i * Register::size);
    return r;
  }
  void store_unaligned(value_type* to) const {
    for (std::size_t i = 0; i < N; ++i) part[i].store_unaligned(to + i * Register::size);
  }
  /// f of the arguments' registers, one by one.
  template <class F, class... Args>
  static Registers map(F f, const Args&... args) {
    Registers r;
    for (std::size_t i = 0; i < N; ++i) r.part[i] = f(args.part[i]...);
    return r;
  }

  template <class F>
  static auto compare(F f, const Registers& a, const Registers& b) {
    return Registers<decltype(f(a.part[0], b.part[0])), N>::map(f, a, b);
  }

  using R = Registers;
  friend R operator+(const R& a, const R& b) { return R::map(std::plus(), a, b); }
  friend R operator-(const R& a, const R& b) { return R::map(std::minus(), a, b); }
  friend R operator*(const R& a, const R& b) { return R::map(std::multiplies(), a, b); }
  friend R operator/(const R& a, const R& b) { return R::map(std::divides(), a, b); }
  friend R operator-(const R& a) { return R::map(std::negate(), a); }
  friend R sqrt(const R& a) {
    using xsimd::sqrt;
    return R::map([](const Register& x) { return sqrt(x); }, a);
  }
  friend auto operator<(const R& a, const R& b) { return compare(std::less(), a, b); }
  friend auto operator>(const R& a, const R& b) { return compare(std::greater(), a, b); }
  friend auto operator>=(const R& a, const R& b) { return compare(std::greater_equal(), a, b); }
  friend auto operator<=(const R& a, const R& b) { return compare(std::less_equal(), a, b); }
  friend auto operator==(const R& a, const R& b) { return compare(std::equal_to(), a, b); }
  friend R operator&(const R& a, const R& b) { return R::map(std::bit_and(), a, b); }
  friend R operator|(const R& a, const R& b) { return R::map(std::bit_or(), a, b); }
  friend R operator&&(const R& a, const R& b) { return a & b; }
  friend R operator||(const R& a, const R& b) { return a | b; }
  friend R operator!(const R& a) {
    return R::map([](const Register& mask) { return opposite(mask); }, a);
  }
  friend R opposite(const R& a) { return !a; }
  friend R operator<<(const R& a, int n) {
    return R::map([n](const Register& x) { return x << n; }, a);
  }
};

}  // namespace tia
