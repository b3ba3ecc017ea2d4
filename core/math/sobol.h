// Low-discrepancy points: Sobol's, Owen-scrambled by hashing, so that any prefix of a pixel's
// samples fills the unit square evenly, and a function of a counter like the words of rng.h.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "core/math/rng.h"

namespace tia {

constexpr std::uint32_t reversed_bits(std::uint32_t v) {
  v = (v >> 1U & 0x55555555) | (v & 0x55555555) << 1U;
  v = (v >> 2U & 0x33333333) | (v & 0x33333333) << 2U;
  v = (v >> 4U & 0x0F0F0F0F) | (v & 0x0F0F0F0F) << 4U;
  v = (v >> 8U & 0x00FF00FF) | (v & 0x00FF00FF) << 8U;
  return v >> 16U | v << 16U;
}

namespace detail {

/// owen_scrambled() of a fraction whose bits are in the reverse order, to such a one.
constexpr std::uint32_t owen_mixed(std::uint32_t v, std::uint32_t seed) {
  v ^= v * 0x3D20ADEA;
  v += seed;
  v *= seed >> 16U | 1U;
  v ^= v * 0x05526C56;
  v ^= v * 0x53A22864;
  return v;
}

}  // namespace detail

/// A nested uniform scramble of v as a binary fraction: whether a bit is flipped depends on all
/// higher bits, by a hash of its own for every seed. Source: Owen (1995); Burley, "Practical
/// Hash-based Owen Scrambling", JCGT 9(4) (2020), section 3; the hash: Vegdahl, "Building a Better
/// LK Hash" (2021), which mixes low bits better than Burley's.
constexpr std::uint32_t owen_scrambled(std::uint32_t v, std::uint32_t seed) {
  return reversed_bits(detail::owen_mixed(reversed_bits(v), seed));
}

namespace detail {

/// Sobol's direction numbers of the first four dimensions, as binary fractions.
/// Source: Joe, Kuo, "Constructing Sobol sequences with better two-dimensional projections", SIAM
/// J. Sci. Comput. 30 (2008), new-joe-kuo-6.
inline constexpr auto sobol_directions = [] {
  struct Row {
    std::uint32_t degree, inner;  // of the primitive polynomial: its inner coefficients as bits
    std::array<std::uint32_t, 3> m;
  };
  constexpr std::array<Row, 3> rows{{{1, 0, {1}}, {2, 1, {1, 3}}, {3, 1, {1, 3, 1}}}};
  std::array<std::array<std::uint32_t, 32>, 4> v{};
  for (std::uint32_t i = 0; i < 32; ++i) v[0][i] = 1U << (31 - i);
  for (std::size_t d = 0; d < rows.size(); ++d) {
    const Row& row = rows[d];
    auto& own = v[d + 1];
    for (std::uint32_t i = 0; i < 32; ++i) {
      if (i < row.degree) {
        own[i] = row.m[i] << (31 - i);
        continue;
      }
      own[i] = own[i - row.degree] ^ own[i - row.degree] >> row.degree;
      for (std::uint32_t k = 1; k < row.degree; ++k)
        if (row.inner >> (row.degree - 1 - k) & 1U) own[i] ^= own[i - k];
    }
  }
  return v;
}();

/// reversed_bits(sobol(index, dimension)), all bits in one expression.
template <std::size_t dimension>
constexpr std::uint32_t sobol_turned(std::uint32_t index) {
  return [&]<std::size_t... bit>(std::index_sequence<bit...>) {
    return ((std::integral_constant<std::uint32_t,
                                    reversed_bits(sobol_directions[dimension][bit])>::value &
             (0U - (index >> bit & 1U))) ^
            ...);
  }
  (std::make_index_sequence<32>());
}

/// reversed_bits(sobol(index, 1)), whose directions are Pascal's triangle, in five steps.
/// Source: Ahmed, "An implementation algorithm of 2D Sobol sequence fast, elegant, and compact"
/// (2024).
constexpr std::uint32_t pascal(std::uint32_t v) {
  v ^= v >> 16U;
  v ^= (v & 0xFF00FF00) >> 8U;
  v ^= (v & 0xF0F0F0F0) >> 4U;
  v ^= (v & 0xCCCCCCCC) >> 2U;
  return v ^ (v & 0xAAAAAAAA) >> 1U;
}

}  // namespace detail

/// Dimension 0 .. 3 of Sobol's point of that index, as a binary fraction.
constexpr std::uint32_t sobol(std::uint32_t index, std::size_t dimension) {
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < 32; ++i)
    bits ^= detail::sobol_directions[dimension][i] & (0U - (index >> i & 1U));
  return bits;
}

namespace detail {

/// What orders and scrambles the points of a block, in each pixel alike for all samples.
template <std::size_t n>
RandomWords<n> sobol_seeds(const std::array<std::uint32_t, n>& x,
                           const std::array<std::uint32_t, n>& y, std::uint32_t block,
                           RandomKey key) {
  constexpr std::uint32_t of_seeds = 0xFFFFFFFF;  // a sample that no pixel has
  RandomWords<n> seeds{x, y, {}, {}};
  seeds.c.fill(of_seeds);
  seeds.d.fill(block);
  philox(seeds, key);
  return seeds;
}

}  // namespace detail

/// The four numbers, as binary fractions, of a sample of several pixels, one in each lane. Every
/// pixel and every block of four dimensions has its points in an order and scrambled in a way of
/// their own, so that blocks are independent of each other, as pixels are. Of 2^k samples from the
/// first on one falls into each of 2^k equal parts of each dimension, and of the first two
/// dimensions' square however it is cut into 2^k equal rectangles along powers of two.
/// Source: Burley (2020), sections 2 and 4 ("padded" points).
template <std::size_t n>
RandomWords<n> sobol_words(const std::array<std::uint32_t, n>& x,
                           const std::array<std::uint32_t, n>& y, std::uint32_t sample,
                           std::uint32_t block, RandomKey key) {
  const RandomWords<n> seeds = detail::sobol_seeds(x, y, block, key);
  // Fractions with their bits reversed, as the scramble has them, are turned back in the end. All
  // bits' steps are one expression, so that compilers take the lanes together.
  RandomWords<n> words;
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint32_t index = owen_scrambled(sample, seeds.a[i]);
    words.a[i] = reversed_bits(detail::owen_mixed(index, seeds.b[i]));
    words.b[i] = reversed_bits(detail::owen_mixed(detail::pascal(index), seeds.c[i]));
    const std::uint32_t c = detail::sobol_turned<2>(index), d = detail::sobol_turned<3>(index);
    words.c[i] = reversed_bits(detail::owen_mixed(c, seeds.d[i]));
    words.d[i] = reversed_bits(detail::owen_mixed(d, seeds.a[i] ^ seeds.b[i]));
  }
  return words;
}

/// SobolPairs: the first two of them, of one block, for less.
template <std::size_t n>
class SobolPairs {
 public:
  using Words = std::array<std::uint32_t, n>;
  SobolPairs(const Words& x, const Words& y, std::uint32_t block, RandomKey key)
      : seeds_(detail::sobol_seeds(x, y, block, key)) {}

  std::array<Words, 2> operator()(std::uint32_t sample) const {
    std::array<Words, 2> words;
    for (std::size_t i = 0; i < n; ++i) {
      const std::uint32_t index = owen_scrambled(sample, seeds_.a[i]);
      words[0][i] = reversed_bits(detail::owen_mixed(index, seeds_.b[i]));
      words[1][i] = reversed_bits(detail::owen_mixed(detail::pascal(index), seeds_.c[i]));
    }
    return words;
  }

 private:
  RandomWords<n> seeds_;
};

}  // namespace tia
