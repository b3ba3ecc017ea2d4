#include "core/film/tonemap.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/core/support.h"

namespace tia {
namespace {

using test::Long;
using test::Random;

const float nan_float = std::numeric_limits<float>::quiet_NaN();
const float infinite_float = std::numeric_limits<float>::infinity();

// IEC 61966-2-1: linear light to signal.
Long srgb_signal(Long light) {
  return light <= 0.0031308L ? 12.92L * light : 1.055L * std::pow(light, 1 / 2.4L) - 0.055L;
}

// Light of every magnitude, below 0 and above 1 too.
float any_light(Random& random) {
  switch (random.below(6)) {
    case 0: return static_cast<float>(random.in(-1, 2));
    case 1: return static_cast<float>(std::exp(random.in(-20, 0)));
    case 2: return static_cast<float>(random.in(0, 0.01));
    default: return static_cast<float>(random.unit());
  }
}

// ---- linear -----------------------------------------------------------------------------------

TEST(TonemapLinear, CodesAndTheirNeighboursComeBack) {
  for (int code = 0; code < 256; ++code) {
    const float light = static_cast<float>(code) / 255;
    EXPECT_EQ(encode_linear(light), code);
    EXPECT_EQ(encode_linear(std::nextafter(light, 2.0F)), code);
    EXPECT_EQ(encode_linear(std::nextafter(light, -1.0F)), code);
  }
}

TEST(TonemapLinear, RoundsToNearest) {
  // In float 255 * light carries one rounding, up to 2^-17 of a code: so near a tie either will do.
  Random random(100);
  for (int i = 0; i < 1'000'000; ++i) {
    const float light = any_light(random);
    const Long exact = 255 * std::clamp<Long>(light, 0, 1);
    const auto nearest = static_cast<int>(std::floor(exact + 0.5L));
    if (encode_linear(light) == nearest) continue;
    EXPECT_NEAR(static_cast<double>(exact - std::floor(exact)), 0.5, 0x1p-16) << light;
  }
}

TEST(TonemapLinear, CodesChangeHalfWay) {
  for (int code = 0; code < 255; ++code) {
    const double tie = (code + 0.5) / 255;
    EXPECT_EQ(encode_linear(static_cast<float>(tie - 1e-6)), code);
    EXPECT_EQ(encode_linear(static_cast<float>(tie + 1e-6)), code + 1);
  }
}

// ---- sRGB -------------------------------------------------------------------------------------

TEST(TonemapSrgb, CodesFollowTheStandardsFormula) {
  Random random(101);
  for (int i = 0; i < 1'000'000; ++i) {
    const float light = any_light(random);
    const Long exact = 255 * srgb_signal(std::clamp<Long>(light, 0, 1));
    const auto nearest = static_cast<int>(std::floor(exact + 0.5L));
    if (encode_srgb(light) == nearest) continue;
    EXPECT_NEAR(static_cast<double>(exact - std::floor(exact)), 0.5, 255e-6) << light;
  }
}

TEST(TonemapSrgb, EachCodeBeginsAtTheFirstFloatFromItsThreshold) {
  // The smallest float with a code above k, by bisection over the floats' order, must be the first
  // float not below the light of the signal (k + 1/2) / 255, in long double.
  for (int k = 0; k < 255; ++k) {
    std::uint32_t below = 0, from = std::bit_cast<std::uint32_t>(1.0F);
    while (from - below > 1) {
      const std::uint32_t middle = below + (from - below) / 2;
      (encode_srgb(std::bit_cast<float>(middle)) > k ? from : below) = middle;
    }
    const Long signal = (k + 0.5L) / 255;
    const Long threshold =
        signal <= 0.04045L ? signal / 12.92L : std::pow((signal + 0.055L) / 1.055L, 2.4L);
    EXPECT_GE(std::bit_cast<float>(from), threshold * (1 - 1e-14L)) << k;
    EXPECT_LT(std::bit_cast<float>(below), threshold * (1 + 1e-14L)) << k;
  }
}

TEST(TonemapSrgb, CodesNeverFallAsLightRises) {
  Random random(102);
  std::vector<float> lights(1'000'000);
  for (float& light : lights) light = any_light(random);
  std::sort(lights.begin(), lights.end());
  int last = 0;
  for (const float light : lights) {
    const int code = encode_srgb(light);
    ASSERT_GE(code, last) << light;
    last = code;
  }
  EXPECT_EQ(last, 255);
}

TEST(TonemapSrgb, SignalsBackToLightFollowThePower) {
  for (int i = 0; i <= 100'000; ++i) {
    const double signal = i / 100'000.0;
    const Long exact =
        signal <= 0.04045 ? signal / 12.92L : std::pow((signal + 0.055L) / 1.055L, 2.4L);
    EXPECT_NEAR(srgb_to_linear(signal), static_cast<double>(exact),
                1e-14 * static_cast<double>(exact))
        << signal;
  }
  EXPECT_EQ(srgb_to_linear(0), 0);
  EXPECT_EQ(srgb_to_linear(1), 1);
}

TEST(TonemapSrgb, EveryCodesOwnLightComesBackAsTheCode) {
  for (int code = 0; code < 256; ++code)
    EXPECT_EQ(encode_srgb(static_cast<float>(srgb_to_linear(code / 255.0))), code);
}

// ---- both -------------------------------------------------------------------------------------

TEST(Tonemap, ClampsToBlackAndWhiteAndTakesNaNForBlack) {
  for (const auto encode : {encode_linear, encode_srgb}) {
    for (const float dark :
         {0.0F, -0.0F, -1e-30F, -1.0F, -infinite_float, nan_float, -nan_float, 1e-40F})
      EXPECT_EQ(encode(dark), 0) << dark;
    for (const float bright : {1.0F, 1.0001F, 255.0F, 3e9F, 1e38F, infinite_float})
      EXPECT_EQ(encode(bright), 255) << bright;
  }
}

TEST(Tonemap, RowsAreDevelopedLikeSingleValues) {
  Random random(103);
  const std::array<float, 6> special{nan_float, infinite_float, -infinite_float, -1, 1e30F, -0.0F};
  for (const Encoding encoding : {Encoding::linear, Encoding::srgb}) {
    const auto encode = encoding == Encoding::linear ? encode_linear : encode_srgb;
    for (int round = 0; round < 2000; ++round) {
      FilmTile tile;
      tile.width = 1 + random.below(FilmTile::size);
      tile.height = FilmTile::size;
      const int y = random.below(FilmTile::size);
      const std::size_t row = static_cast<std::size_t>(y * FilmTile::size);
      tile.r.fill(nan_float);
      tile.g.fill(nan_float);
      tile.b.fill(nan_float);
      const auto light = [&] {
        return random.chance(0.1) ? special[static_cast<std::size_t>(random.below(6))]
                                  : any_light(random);
      };
      for (std::size_t x = 0; x < static_cast<std::size_t>(tile.width); ++x) {
        tile.r[row + x] = light();
        tile.g[row + x] = light();
        tile.b[row + x] = light();
      }
      std::array<std::uint8_t, row_codes> codes{};
      develop_row(tile, y, encoding, codes);
      for (std::size_t x = 0; x < static_cast<std::size_t>(tile.width); ++x) {
        ASSERT_EQ(codes[3 * x], encode(tile.r[row + x])) << tile.r[row + x];
        ASSERT_EQ(codes[3 * x + 1], encode(tile.g[row + x])) << tile.g[row + x];
        ASSERT_EQ(codes[3 * x + 2], encode(tile.b[row + x])) << tile.b[row + x];
      }
    }
  }
}

}  // namespace
}  // namespace tia
