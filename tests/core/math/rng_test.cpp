#include "core/math/rng.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "tests/core/support.h"

namespace tia {
namespace {

using test::Random;
using Words = std::array<std::uint32_t, 4>;

Words drawn(const Words& counter, std::int64_t seed) {
  RandomWords<1> words{{counter[0]}, {counter[1]}, {counter[2]}, {counter[3]}};
  philox(words, RandomKey(seed));
  return {words.a[0], words.b[0], words.c[0], words.d[0]};
}

// Pearson's statistic against equal shares, as standard deviations from its mean: chi-squared of k
// cells has k - 1 degrees of freedom, mean k - 1, variance 2 (k - 1).
double surprise(const std::vector<int>& counts, double expected) {
  double statistic = 0;
  for (const int count : counts) statistic += (count - expected) * (count - expected) / expected;
  const auto freedom = static_cast<double>(counts.size()) - 1;
  return (statistic - freedom) / std::sqrt(2 * freedom);
}

TEST(Philox, GivesTheKnownAnswers) {
  // Source: Random123 (Salmon et al.), tests/kat_vectors, philox4x32 10.
  EXPECT_EQ(drawn({0, 0, 0, 0}, 0), (Words{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(drawn({~0U, ~0U, ~0U, ~0U}, -1),
            (Words{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(drawn({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, 0x299f31d0a4093822),
            (Words{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(Philox, LanesAreDrawnAsIfAlone) {
  Random random(70);
  RandomWords<16> many;
  std::vector<Words> counters(16);
  for (std::size_t i = 0; i < 16; ++i) {
    for (std::uint32_t& word : counters[i]) word = static_cast<std::uint32_t>(random.in(0, 4e9));
    many.a[i] = counters[i][0];
    many.b[i] = counters[i][1];
    many.c[i] = counters[i][2];
    many.d[i] = counters[i][3];
  }
  philox(many, RandomKey(12345));
  for (std::size_t i = 0; i < 16; ++i)
    EXPECT_EQ(drawn(counters[i], 12345), (Words{many.a[i], many.b[i], many.c[i], many.d[i]}));
}

TEST(Philox, WordsOfNeighbouringPixelsAreUniform) {
  constexpr int side = 256, cells = 256;
  for (std::size_t word = 0; word < 4; ++word) {
    std::vector<int> high(cells), low(cells);
    for (std::uint32_t y = 0; y < side; ++y) {
      for (std::uint32_t x = 0; x < side; ++x) {
        const std::uint32_t value = drawn({x, y, 0, 0}, 0)[word];
        ++high[value >> 24U];
        ++low[value & 255U];
      }
    }
    EXPECT_LT(std::fabs(surprise(high, side * side / cells)), 5) << word;
    EXPECT_LT(std::fabs(surprise(low, side * side / cells)), 5) << word;
  }
}

TEST(Philox, NeighbouringCountersAndSeedsAreIndependent) {
  // The pairs of two streams' words fall evenly into the 16 x 16 cells of their highest bits,
  // whichever part of the counter or of the seed tells the two streams apart.
  struct Step {
    Words counter;
    std::int64_t seed;
  };
  for (const Step& step : {Step{{1, 0, 0, 0}, 0},
                           {{0, 1, 0, 0}, 0},
                           {{0, 0, 1, 0}, 0},
                           {{0, 0, 0, 1}, 0},
                           {{0, 0, 0, 0}, 1},
                           {{0, 0, 0, 0}, 1LL << 52}}) {
    std::vector<int> pairs(256);
    constexpr std::uint32_t sampler_state = 32768;
    for (std::uint32_t i = 0; i < sampler_state; ++i) {
      const Words counter{2 * (i & 127U), 2 * (i >> 7U), 0, 0};
      Words next = counter;
      for (std::size_t k = 0; k < 4; ++k) next[k] += step.counter[k];
      ++pairs[drawn(counter, 4)[0] >> 28U << 4U | drawn(next, 4 + step.seed)[0] >> 28U];
    }
    EXPECT_LT(std::fabs(surprise(pairs, sampler_state / 256.0)), 5);
  }
}

TEST(Philox, EveryBitOfASeedMatters) {
  // One bit of the seed turns about half of the 128 bits drawn: binomial, deviation sqrt(32) = 5.7.
  for (const std::int64_t seed : {std::int64_t{0}, std::int64_t{9007199254740991}}) {
    const Words before = drawn({3, 5, 7, 0}, seed);
    for (int bit = 0; bit < 53; ++bit) {
      const Words after = drawn({3, 5, 7, 0}, seed ^ (std::int64_t{1} << bit));
      int turned = 0;
      for (std::size_t k = 0; k < 4; ++k) turned += std::popcount(before[k] ^ after[k]);
      EXPECT_NEAR(turned, 64, 30) << bit;
    }
  }
}

TEST(Philox, NumbersFillTheUnitIntervalFromZeroToJustBelowOne) {
  EXPECT_EQ(unit_float(0), 0);
  EXPECT_EQ(unit_float(~0U), 1 - 0x1p-24F);
  EXPECT_EQ(unit_float(0x80000000), 0.5F);
  EXPECT_EQ(unit_double(0), 0);
  EXPECT_EQ(unit_double(~0U), 1 - 0x1p-32);
}

}  // namespace
}  // namespace tia
