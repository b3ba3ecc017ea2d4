// Pictures in, with alpha.
#include <gmock/gmock.h>

#include "core/film/decode.h"
#include "core/film/png.h"
#include "tests/core/film/files.h"

namespace tia {
namespace {

using test::Bytes;
using test::Random;

Bytes rgba_of(const Bytes& file) {
  const auto result = decode_picture_rgba(file);
  const auto* image = std::get_if<ImageRgba8>(&result);
  return image != nullptr ? image->rgba : Bytes{};
}

Bytes without_alpha(const Bytes& rgba) {
  Bytes rgb;
  for (std::size_t i = 0; i < rgba.size(); ++i)
    if (i % 4 != 3) rgb.push_back(rgba[i]);
  return rgb;
}

TEST(DecodeAlpha, PngsOfEveryKindHaveTheirAlpha) {
  const auto one = [](char depth, char color, const std::string& row) {
    return rgba_of(test::png({1, 1, depth, color}, row));
  };
  EXPECT_EQ(one(8, test::grey, "\x40"), (Bytes{64, 64, 64, 255}));
  EXPECT_EQ(one(16, test::grey, "\x40\x99"), (Bytes{64, 64, 64, 255}));
  EXPECT_EQ(one(8, test::grey_alpha, "\x40\x07"), (Bytes{64, 64, 64, 7}));
  EXPECT_EQ(one(8, test::rgb, "\x01\x02\x03"), (Bytes{1, 2, 3, 255}));
  EXPECT_EQ(one(8, test::rgba, "\x01\x02\x03\x04"), (Bytes{1, 2, 3, 4}));
  EXPECT_EQ(one(16, test::rgba, "\x01\x99\x02\x99\x03\x99\x04\x99"), (Bytes{1, 2, 3, 4}));
}

// Source: W3C PNG (third edition), 11.3.1.1.
TEST(DecodeAlpha, ATransparentColourHasNoAlpha) {
  const Bytes grey =
      test::with_chunk_before_pixels(test::png({2, 1, 8, test::grey}, "\x40\x41"),
                                     test::png_chunk("tRNS", std::string("\0\x41", 2)));
  EXPECT_EQ(rgba_of(grey), (Bytes{64, 64, 64, 255, 65, 65, 65, 0}));
  const Bytes rgb =
      test::with_chunk_before_pixels(test::png({2, 1, 8, test::rgb}, "\x01\x02\x03\x01\x02\x04"),
                                     test::png_chunk("tRNS", std::string("\0\x01\0\x02\0\x03", 6)));
  EXPECT_EQ(rgba_of(rgb), (Bytes{1, 2, 3, 0, 1, 2, 4, 255}));
}

TEST(DecodeAlpha, APaletteHasTheAlphaThatItNames) {
  const Bytes file =
      test::png({3, 1, 8, test::palette}, std::string("\0\1\x09", 3), "\x09\x08\x07\x06\x05\x04");
  EXPECT_EQ(rgba_of(file), (Bytes{9, 8, 7, 255, 6, 5, 4, 255, 0, 0, 0, 255}));
  EXPECT_EQ(rgba_of(test::with_chunk_before_pixels(file, test::png_chunk("tRNS", "\x30"))),
            (Bytes{9, 8, 7, 48, 6, 5, 4, 255, 0, 0, 0, 255}));
}

TEST(DecodeAlpha, JpegsAreOpaque) {
  const Bytes rgba = rgba_of(test::flat_jpeg({100}));
  ASSERT_EQ(rgba.size(), 256U);
  for (std::size_t i = 0; i < rgba.size(); ++i) EXPECT_EQ(rgba[i], i % 4 == 3 ? 255 : 100);
}

TEST(DecodeAlpha, OnlyPngsAndJpegsBeginLikePictures) {
  EXPECT_TRUE(is_picture(test::png({1, 1, 8, test::grey}, "\x40")));
  EXPECT_TRUE(is_picture(test::flat_jpeg({100})));
  EXPECT_FALSE(is_picture({}));
  EXPECT_FALSE(is_picture(test::to_bytes("\x89PNG\r\n\x1A")));
  EXPECT_FALSE(is_picture(test::to_bytes("RIFF....WEBP")));
}

// Whatever bytes come: no crash (a sanitiser's build sees more), and the codes of decode_picture.
TEST(DecodeAlpha, DamagedFilesHaveTheSameColoursAsWithoutAlpha) {
  Random random(332);
  Image8 image(20, 13);
  for (auto& code : image.rgb) code = static_cast<std::uint8_t>(random.below(256));
  const Bytes files[] = {
      test::to_bytes(encode_png(image)),
      test::with_chunk_before_pixels(
          test::png({4, 2, 8, test::palette}, "\1\2\1\3\1\2\1\3", "\x09\x08\x07"),
          test::png_chunk("tRNS", "\x30")),
      test::png({2, 2, 8, test::rgba}, "abcdefghijklmnop"), test::flat_jpeg({100, 140, 150})};
  for (int i = 0; i < 2000; ++i) {
    Bytes file = files[i % 4];
    for (int changes = 1 + random.below(4); changes > 0; --changes)
      file[static_cast<std::size_t>(random.below(static_cast<int>(file.size())))] =
          static_cast<std::uint8_t>(random.below(256));
    const auto plain = decode_picture(file);
    const Bytes rgba = rgba_of(file);
    ASSERT_EQ(rgba.empty(), plain.index() == 1);
    if (const auto* codes = std::get_if<Image8>(&plain)) {
      ASSERT_EQ(codes->rgb, without_alpha(rgba));
    }
  }
}

}  // namespace
}  // namespace tia
