#include "core/film/film.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/core/film/tiles.h"

namespace tia {
namespace {

using test::Random;
using test::tiles_of;

Image random_light(int width, int height, std::uint64_t seed) {
  Random random(seed);
  Image image(width, height);
  for (float& value : image.rgb) value = static_cast<float>(random.in(-0.2, 1.2));
  return image;
}

TEST(Film, LinearFilmKeepsEveryBitWhateverTheBlocks) {
  const Image light = random_light(101, 67, 110);
  for (const int side : {32, 31, 7, 1}) {
    LinearFilm film(light.width, light.height);
    for (const FilmTile& tile : tiles_of(light, side)) film.put(tile);
    EXPECT_EQ(test::bits_of(film.image()), test::bits_of(light)) << side;
  }
}

TEST(Film, DisplayFilmHoldsTheCodesOfTheLinearFilmsLight) {
  const Image light = random_light(101, 67, 111);
  for (const Transfer transfer : {Transfer::linear, Transfer::srgb}) {
    const auto encode = transfer == Transfer::linear ? encode_linear : encode_srgb;
    for (const int side : {32, 31, 7, 1}) {
      DisplayFilm film(light.width, light.height, transfer);
      for (const FilmTile& tile : tiles_of(light, side)) film.put(tile);
      ASSERT_EQ(film.image().rgb.size(), light.rgb.size());
      for (std::size_t i = 0; i < light.rgb.size(); ++i)
        ASSERT_EQ(film.image().rgb[i], encode(light.rgb[i])) << side << ": " << i;
    }
  }
}

// W3C PNG (third edition), 9.2: filter 1, each code less that of the pixel at its left.
std::vector<std::uint8_t> filtered(const Image8& image) {
  const std::size_t row_bytes = 3 * static_cast<std::size_t>(image.width);
  std::vector<std::uint8_t> lines;
  for (std::size_t i = 0; i < image.rgb.size(); ++i) {
    if (i % row_bytes == 0) lines.push_back(1);
    const int left = i % row_bytes < 3 ? 0 : image.rgb[i - 3];
    lines.push_back(static_cast<std::uint8_t>(image.rgb[i] - left));
  }
  return lines;
}

TEST(Film, ScanlineFilmHoldsTheDisplayFilmsRowsFiltered) {
  const DisplayRule rule{FeatureDisplay::normal, {Transfer::linear}};
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 40}, {22, 3}, {101, 67}, {400, 33}}) {
    const Image light = random_light(width, height, 112);
    DisplayFilm codes(width, height, rule);
    for (const FilmTile& tile : tiles_of(light, 32)) codes.put(tile);
    const std::vector<std::uint8_t> expected = filtered(codes.image());
    for (const int side : {32, 31, 7, 1}) {
      std::vector<FilmTile> tiles = tiles_of(light, side);
      for (int turn = 0; turn < 3; ++turn) {
        ScanlineFilm film(width, height, rule);
        for (const FilmTile& tile : tiles) film.put(tile);
        const Scanlines& lines = film.scanlines();
        ASSERT_EQ(lines.size(), expected.size());
        EXPECT_TRUE(std::equal(expected.begin(), expected.end(), lines.data())) << side;
        std::rotate(tiles.begin(), tiles.begin() + static_cast<std::ptrdiff_t>(tiles.size() / 2),
                    tiles.end());
        if (turn == 1) std::ranges::reverse(tiles);
      }
    }
  }
}

TEST(Film, ScanlinesAreTheSameHoweverManyThreadsPutTheirBlocks) {
  const Image light = random_light(333, 217, 113);
  const std::vector<FilmTile> tiles = tiles_of(light, 16);
  DisplayFilm codes(333, 217, Transfer::srgb);
  for (const FilmTile& tile : tiles) codes.put(tile);
  const std::vector<std::uint8_t> expected = filtered(codes.image());
  Pool pool(5);
  for (int turn = 0; turn < 20; ++turn) {
    ScanlineFilm film(333, 217, {FeatureDisplay::light, {Transfer::srgb}});
    pool.for_each(static_cast<int>(tiles.size()), 5, {},
                  [&](int i) { film.put(tiles[static_cast<std::size_t>(i)]); });
    EXPECT_TRUE(std::equal(expected.begin(), expected.end(), film.scanlines().data()));
  }
}

TEST(Film, PixelIsThreeFloatsInRowsFromTheTop) {
  Image image(3, 2);
  EXPECT_EQ(image.rgb.size(), 18U);
  EXPECT_EQ(image.at(0, 0), image.rgb.data());
  EXPECT_EQ(image.at(2, 0), image.rgb.data() + 6);
  EXPECT_EQ(image.at(0, 1), image.rgb.data() + 9);
}

}  // namespace
}  // namespace tia
