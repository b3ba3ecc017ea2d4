// How numbers that are no light become codes.
#include "core/film/display.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include "core/film/film.h"

namespace tia::test {
namespace {

using Codes = std::vector<int>;

// The codes of a picture of one pixel.
Codes codes_of(const DisplayRule& rule, float r, float g, float b) {
  FilmTile tile;
  tile.width = tile.height = 1;
  tile.r[0] = r;
  tile.g[0] = g;
  tile.b[0] = b;
  DisplayFilm film(1, 1, rule);
  film.put(tile);
  return {film.image().rgb.begin(), film.image().rgb.end()};
}
Codes codes_of(FeatureDisplay shown, float v) {
  return codes_of({shown, {Transfer::srgb}}, v, v, v);
}
Codes grey(int code) { return {code, code, code}; }

TEST(Display, LightGoesThroughTheCurveAndDataDoesNot) {
  EXPECT_EQ(codes_of(FeatureDisplay::light, 0.5F), grey(188));  // IEC 61966-2-1: 0.7354 x 255
  EXPECT_EQ(codes_of({FeatureDisplay::light, {Transfer::linear}}, 0.5F, 0.5F, 0.5F), grey(128));
  EXPECT_EQ(codes_of(FeatureDisplay::share, 0.5F), grey(128));
}

TEST(Display, ANormalIsHalfOfItAroundOneHalfAndNoneIsBlack) {
  const DisplayRule rule{FeatureDisplay::normal, {Transfer::srgb}};
  EXPECT_EQ(codes_of(rule, 0, 0, 1), (Codes{128, 128, 255}));
  EXPECT_EQ(codes_of(rule, -1, 0.2F, 0), (Codes{0, 153, 128}));  // 255 x 0.6 = 153
  EXPECT_EQ(codes_of(rule, 0, 0, 0), grey(0));
}

TEST(Display, ADistanceIsTheInverseOfOneMore) {
  EXPECT_EQ(codes_of(FeatureDisplay::depth, 0), grey(255));
  EXPECT_EQ(codes_of(FeatureDisplay::depth, 4), grey(51));
  EXPECT_EQ(codes_of(FeatureDisplay::depth, std::numeric_limits<float>::infinity()), grey(0));
}

// log2(1 + c) / 16: c = 2^k - 1 gives k / 16.
TEST(Display, ACostIsASixteenthOfItsLogarithm) {
  for (int k = 0; k <= 16; ++k)
    EXPECT_EQ(codes_of(FeatureDisplay::cost, std::ldexp(1.0F, k) - 1),
              grey(static_cast<int>(std::lround(255 * k / 16.0))));
  EXPECT_EQ(codes_of(FeatureDisplay::cost, 1e9F), grey(255));
}

TEST(Display, TheFirst4096NumbersHaveColoursOfTheirOwn) {
  std::set<Codes> seen{codes_of(FeatureDisplay::number, 0)};
  EXPECT_EQ(*seen.begin(), grey(0));
  for (int i = 1; i <= 4096; ++i) {
    const Codes color = codes_of(FeatureDisplay::number, static_cast<float>(i));
    EXPECT_TRUE(seen.insert(color).second) << i;
    EXPECT_GE(*std::min_element(color.begin(), color.end()), 64) << i;
  }
}

TEST(Display, TheFirst256NumbersAreToldApartByEye) {
  std::vector<Codes> colors;
  for (int i = 1; i <= 256; ++i) {
    const Codes color = codes_of(FeatureDisplay::number, static_cast<float>(i));
    for (const Codes& other : colors) {
      int widest = 0;
      for (std::size_t k = 0; k < 3; ++k) widest = std::max(widest, std::abs(color[k] - other[k]));
      ASSERT_GE(widest, 16) << i;
    }
    colors.push_back(color);
  }
}

TEST(Display, OnlyTheBlocksOwnPixelsAreShown) {
  FilmTile tile;
  tile.width = 3;
  tile.height = 2;
  tile.r.fill(4);
  tile.g.fill(4);
  tile.b.fill(4);
  show(FeatureDisplay::depth, tile);
  for (std::size_t i = 0; i < tile.r.size(); ++i) {
    const bool inside = i % FilmTile::size < 3 && i / FilmTile::size < 2;
    EXPECT_EQ(tile.r[i], inside ? 0.2F : 4.0F);
  }
}

}  // namespace
}  // namespace tia::test
