// Half: floating-point numbers of 16 bits.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace tia {

/// The bits of the half nearest to x, of two equally near ones of the even one. From 65520 on it is
/// infinite; of NaN one that has no sign. Source: IEEE 754-2019, 3.6 (binary16), 4.3.1.
inline std::uint16_t half_of(float x) {
  constexpr std::uint32_t infinite = 0x7C00, not_a_number = 0x7E00;
  const auto bits = std::bit_cast<std::uint32_t>(x);
  const std::uint32_t sign = bits >> 16U & 0x8000U, magnitude = bits & 0x7FFFFFFFU;
  if (std::isnan(x)) return static_cast<std::uint16_t>(not_a_number);
  if (!(std::fabs(x) < 65520.0F)) return static_cast<std::uint16_t>(sign | infinite);
  if (std::fabs(x) < 0x1p-14F) {  // multiples of 2^-24, as floats from 0.5 on are
    const auto moved = std::bit_cast<std::uint32_t>(std::fabs(x) + 0.5F);
    return static_cast<std::uint16_t>(sign | (moved - std::bit_cast<std::uint32_t>(0.5F)));
  }
  const std::uint32_t rebiased = magnitude - ((127U - 15U) << 23U), odd = magnitude >> 13U & 1U;
  return static_cast<std::uint16_t>(sign | (rebiased + 0x0FFFU + odd) >> 13U);
}

}  // namespace tia
