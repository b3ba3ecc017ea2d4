// Quad: four doubles that are computed together, as the channels of a texel are. How many registers
// they take never changes a result.
#pragma once

#include <array>
#include <cstdint>

#include "core/math/wide.h"

namespace tia {

using Quad = Registers<DoubleRegister, 4 / DoubleRegister::size>;

[[gnu::always_inline]] inline Quad quad_of(double a, double b, double c, double d) {
#if defined(__AVX__)
  return Quad::of(DoubleRegister(_mm256_setr_pd(a, b, c, d)));
#elif defined(__SSE2__)
  return Quad::of(DoubleRegister(_mm_setr_pd(a, b)), DoubleRegister(_mm_setr_pd(c, d)));
#else
  const double all[] = {a, b, c, d};
  return Quad::load_unaligned(all);
#endif
}
/// Of four integers one after the other.
[[gnu::always_inline]] inline Quad quad_of(const std::uint16_t* from) {
#if defined(__AVX2__)
  const __m128i four = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(from));
  return Quad::of(DoubleRegister(_mm256_cvtepi32_pd(_mm_cvtepu16_epi32(four))));
#else
  return quad_of(from[0], from[1], from[2], from[3]);
#endif
}
inline std::array<double, 4> doubles_of(const Quad& quad) {
  std::array<double, 4> all;
  quad.store_unaligned(all.data());
  return all;
}

}  // namespace tia
