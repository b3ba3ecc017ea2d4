#include "core/math/sobol.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <set>
#include <vector>

#include "tests/core/support.h"

namespace tia {
namespace {

using test::Random;
using Words = std::array<std::uint32_t, 4>;

Words words_of(std::uint32_t x, std::uint32_t y, std::uint32_t sample, std::uint32_t block,
               std::int64_t seed) {
  const RandomWords<1> words = sobol_words<1>({x}, {y}, sample, block, RandomKey(seed));
  return {words.a[0], words.b[0], words.c[0], words.d[0]};
}
std::uint32_t any_word(Random& random) { return static_cast<std::uint32_t>(random.in(0, 4.29e9)); }

TEST(Sobol, FirstPointsAreTheKnownOnes) {
  // Source: Sobol (1967), as Joe and Kuo's numbers give them in the order of the binary index.
  constexpr std::array<double, 8> first{0, 0.5, 0.25, 0.75, 0.125, 0.625, 0.375, 0.875};
  constexpr std::array<double, 8> second{0, 0.5, 0.75, 0.25, 0.625, 0.125, 0.375, 0.875};
  for (std::uint32_t i = 0; i < 8; ++i) {
    EXPECT_EQ(unit_double(sobol(i, 0)), first[i]);
    EXPECT_EQ(unit_double(sobol(i, 1)), second[i]);
  }
}

// The words as the method defines them, one point and one number after the other.
TEST(SobolWords, AreScrambledPoints) {
  Random random(83);
  for (int round = 0; round < 2000; ++round) {
    RandomWords<1> seeds{{any_word(random)}, {any_word(random)}, {0xFFFFFFFF}, {any_word(random)}};
    const std::uint32_t sample = any_word(random) >> random.below(32);
    const Words words = words_of(seeds.a[0], seeds.b[0], sample, seeds.d[0], round);
    philox(seeds, RandomKey(round));
    const std::uint32_t index = owen_scrambled(sample, seeds.a[0]);
    const Words of_each{seeds.b[0], seeds.c[0], seeds.d[0], seeds.a[0] ^ seeds.b[0]};
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_EQ(words[i], owen_scrambled(sobol(index, i), of_each[i])) << sample << ", " << i;
  }
}

// A nested scramble keeps how long the common start of two fractions is.
TEST(OwenScramble, KeepsWhereTwoNumbersPart) {
  Random random(80);
  for (int i = 0; i < 20'000; ++i) {
    const std::uint32_t a = any_word(random), seed = any_word(random);
    const std::uint32_t b =
        a ^ (1U << random.below(32)) ^ (any_word(random) >> random.whole(1, 31));
    const std::uint32_t before = a ^ b, after = owen_scrambled(a, seed) ^ owen_scrambled(b, seed);
    ASSERT_EQ(std::countl_zero(before), std::countl_zero(after)) << a << " " << b << " " << seed;
  }
}

// Each bit is flipped in half of the seeds, whatever the bits above it are.
TEST(OwenScramble, FlipsEachBitByHalfOfTheSeeds) {
  Random random(81);
  constexpr int seeds = 4096;
  for (const std::uint32_t v : {0U, ~0U, 0x12345678U, any_word(random)}) {
    std::array<int, 32> flipped{};
    for (int i = 0; i < seeds; ++i) {
      const std::uint32_t change = v ^ owen_scrambled(v, any_word(random));
      for (std::size_t bit = 0; bit < 32; ++bit) flipped[bit] += change >> bit & 1U;
    }
    for (const int count : flipped) EXPECT_NEAR(count, seeds / 2, 5 * std::sqrt(seeds) / 2) << v;
  }
}

// Of the first 2^k samples one is in each part, along every dimension and, of the first two, in
// each rectangle of 2^-a by 2^-(k - a): they are a (0, 2)-sequence. Source: Niederreiter, "Random
// number generation and quasi-Monte Carlo methods" (1992), ch. 4.
TEST(SobolWords, OfAPowerOfTwoFillEveryPartOnce) {
  Random random(82);
  for (int round = 0; round < 60; ++round) {
    const std::uint32_t x = any_word(random), y = any_word(random), block = any_word(random);
    const auto seed = static_cast<std::int64_t>(random.in(0, 9e15));
    const auto k = static_cast<std::uint32_t>(random.whole(1, 9));
    std::vector<Words> samples;
    for (std::uint32_t i = 0; i < 1U << k; ++i) samples.push_back(words_of(x, y, i, block, seed));
    for (std::uint32_t a = 0; a <= k; ++a) {
      std::set<std::pair<std::uint32_t, std::uint32_t>> parts;
      for (const Words& words : samples)
        parts.emplace(std::uint64_t{words[0]} >> (32 - a), std::uint64_t{words[1]} >> (32 - k + a));
      EXPECT_EQ(parts.size(), samples.size()) << k << " " << a;
    }
    for (std::size_t dimension = 0; dimension < 4; ++dimension) {
      std::set<std::uint32_t> parts;
      for (const Words& words : samples) parts.insert(words[dimension] >> (32 - k));
      EXPECT_EQ(parts.size(), samples.size()) << k << ", dimension " << dimension;
    }
  }
}

// Pearson's statistic of two numbers of each of many pixels in 8 x 8 cells, as standard deviations
// from its mean.
template <class Pair>
double surprise(const Pair& pair) {
  constexpr int side = 128, cells = 64;
  std::array<int, cells> counts{};
  for (std::uint32_t y = 0; y < side; ++y)
    for (std::uint32_t x = 0; x < side; ++x) {
      const auto [u, v] = pair(x, y);
      ++counts[(u >> 29U) * 8 + (v >> 29U)];
    }
  constexpr double expected = double(side) * side / cells;
  double statistic = 0;
  for (const int count : counts) statistic += (count - expected) * (count - expected) / expected;
  return (statistic - (cells - 1)) / std::sqrt(2.0 * (cells - 1));
}

TEST(SobolWords, PixelsAndBlocksAreIndependent) {
  for (std::uint32_t sample : {0U, 1U, 7U, 100U}) {
    EXPECT_LT(surprise([&](std::uint32_t x, std::uint32_t y) {
                return std::pair(words_of(x, y, sample, 0, 3)[0],
                                 words_of(x + 1, y, sample, 0, 3)[0]);
              }),
              4);
    EXPECT_LT(surprise([&](std::uint32_t x, std::uint32_t y) {
                return std::pair(words_of(x, y, sample, 0, 3)[0], words_of(x, y, sample, 1, 3)[0]);
              }),
              4);
    EXPECT_LT(surprise([&](std::uint32_t x, std::uint32_t y) {
                return std::pair(words_of(x, y, sample, 0, 3)[2], words_of(x, y, sample, 0, 4)[2]);
              }),
              4);
    EXPECT_LT(surprise([&](std::uint32_t x, std::uint32_t y) {
                const Words words = words_of(x, y, sample, 5, 3);
                return std::pair(words[1], words[3]);
              }),
              4);
  }
}

// The mean of u v over n points: independent ones are off by sqrt((1/9 - 1/16) / n).
TEST(SobolWords, HaveASmallErrorWhereIndependentOnesHaveALargeOne) {
  constexpr std::uint32_t n = 64, pixels = 500;
  double squares = 0, sum = 0;
  for (std::uint32_t x = 0; x < pixels; ++x) {
    double mean = 0;
    for (std::uint32_t i = 0; i < n; ++i) {
      const Words words = words_of(x, 9, i, 2, 1);
      mean += unit_double(words[0]) * unit_double(words[1]) / n;
    }
    sum += mean - 0.25;
    squares += (mean - 0.25) * (mean - 0.25);
  }
  const double error = std::sqrt(squares / pixels), independent = std::sqrt((1 / 9. - 1 / 16.) / n);
  EXPECT_LT(error, independent / 8);
  EXPECT_LT(std::fabs(sum / pixels), 5 * error / std::sqrt(pixels)) << "without bias";
}

// By the slope of the error over n = 16 .. 4096 in logarithms, of the root of its mean square over
// many scrambles: independent numbers' is -1/2. Integrands of up to four dimensions whose integrals
// are known, of one block and of two, as paths take them.
TEST(SobolWords, ErrorsOfSmoothIntegrandsFallFasterThanNToTheMinusNineTenths) {
  using Units = std::array<double, 8>;
  struct Smooth {
    const char* name;
    double (*f)(const Units&);
    double integral;
  };
  const double e = std::exp(1.0) - 1, sine = 1 - std::cos(1.0);
  const Smooth all[] = {
      {"u v", [](const Units& u) { return u[0] * u[1]; }, 0.25},
      {"exp(u + v)", [](const Units& u) { return std::exp(u[0] + u[1]); }, e * e},
      {"sin u exp(-v)", [](const Units& u) { return std::sin(u[2]) * std::exp(-u[3]); },
       sine * (1 - std::exp(-1.0))},
      {"Genz' Gaussian peak of four",
       [](const Units& u) {
         double sum = 0;
         for (std::size_t i = 0; i < 4; ++i) sum += (u[i] - 0.5) * (u[i] - 0.5);
         return std::exp(-sum);
       },
       std::pow(std::sqrt(pi) * std::erf(0.5), 4)},
      {"sums over two blocks", [](const Units& u) { return std::exp(u[0]) + std::sin(u[5]); },
       e + sine}};
  constexpr std::uint32_t pixels = 32;
  constexpr int first = 4, last = 12;
  std::array<std::array<double, last + 1>, std::size(all)> squares{};
  for (std::uint32_t x = 0; x < pixels; ++x) {
    std::array<double, std::size(all)> sums{};
    for (std::uint32_t i = 0; i < 1U << last; ++i) {
      const Words a = words_of(x, 3, i, 4, 1), b = words_of(x, 3, i, 5, 1);
      const Units u{unit_double(a[0]), unit_double(a[1]), unit_double(a[2]), unit_double(a[3]),
                    unit_double(b[0]), unit_double(b[1]), unit_double(b[2]), unit_double(b[3])};
      for (std::size_t k = 0; k < std::size(all); ++k) sums[k] += all[k].f(u);
      if (!std::has_single_bit(i + 1)) continue;
      const auto level = static_cast<std::size_t>(std::countr_zero(i + 1));
      for (std::size_t k = 0; k < std::size(all); ++k) {
        const double off = sums[k] / (i + 1) - all[k].integral;
        squares[k][level] += off * off / pixels;
      }
    }
  }
  for (std::size_t k = 0; k < std::size(all); ++k) {
    // Least squares over the levels.
    double xy = 0, xx = 0;
    for (int level = first; level <= last; ++level) {
      const double x = level - (first + last) / 2.0;
      xy += x * std::log2(squares[k][static_cast<std::size_t>(level)]) / 2, xx += x * x;
    }
    EXPECT_LT(xy / xx, -0.9) << all[k].name;
  }
}

TEST(SobolWords, LanesAreDrawnAsIfAlone) {
  Random random(83);
  std::array<std::uint32_t, 16> x{}, y{};
  for (std::size_t i = 0; i < 16; ++i) x[i] = any_word(random), y[i] = any_word(random);
  const RandomWords<16> many = sobol_words<16>(x, y, 11, 3, RandomKey(12345));
  for (std::size_t i = 0; i < 16; ++i)
    EXPECT_EQ(words_of(x[i], y[i], 11, 3, 12345),
              (Words{many.a[i], many.b[i], many.c[i], many.d[i]}));
}

}  // namespace
}  // namespace tia
