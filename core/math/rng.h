// Counter-based random numbers: a pure function of a key and a counter, without any state, so that
// what is drawn for one sample depends on nothing that was drawn before.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace tia {

/// The stream's key: all 64 bits of a seed matter.
struct RandomKey {
  std::uint32_t low = 0, high = 0;

  explicit RandomKey(std::int64_t seed)
      : low(static_cast<std::uint32_t>(seed)),
        high(static_cast<std::uint32_t>(static_cast<std::uint64_t>(seed) >> 32U)) {}
};

/// RandomWords: four 32-bit words in each of n lanes; a counter, or what is drawn for it.
template <std::size_t n>
struct RandomWords {
  std::array<std::uint32_t, n> a, b, c, d;
};

/// Turns n counters into four random words each. Different counters give independent words.
/// Source: Salmon, Moraes, Dror, Shaw, "Parallel random numbers: as easy as 1, 2, 3", 2011,
/// Philox-4x32-10.
template <std::size_t n>
void philox(RandomWords<n>& words, RandomKey key) {
  for (int round = 0; round < 10; ++round) {
    for (std::size_t i = 0; i < n; ++i) {
      const std::uint64_t ac = std::uint64_t{0xD2511F53} * words.a[i];
      const std::uint64_t bd = std::uint64_t{0xCD9E8D57} * words.c[i];
      words.a[i] = static_cast<std::uint32_t>(bd >> 32U) ^ words.b[i] ^ key.low;
      words.b[i] = static_cast<std::uint32_t>(bd);
      words.c[i] = static_cast<std::uint32_t>(ac >> 32U) ^ words.d[i] ^ key.high;
      words.d[i] = static_cast<std::uint32_t>(ac);
    }
    key.low += 0x9E3779B9;   // the golden ratio's digits
    key.high += 0xBB67AE85;  // those of sqrt(3) - 1
  }
}

/// Returns: a multiple of 2^-24 in [0, 1), uniform.
inline float unit_float(std::uint32_t word) {
  return static_cast<float>(static_cast<std::int32_t>(word >> 8U)) * 0x1p-24F;
}
/// Returns: a multiple of 2^-32 in [0, 1), uniform.
inline double unit_double(std::uint32_t word) { return word * 0x1p-32; }

}  // namespace tia
