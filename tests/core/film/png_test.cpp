// PNG files read back by stb_image, which shares nothing with the encoder's compressor; the
// container's chunks and checksums by libpng.
#include "core/film/png.h"

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <memory>
#include <string_view>
#include <thread>

#include "core/parallel/stopped.h"
#include "tests/core/film/png_chunks.h"

#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#include <stb/stb_image.h>

namespace tia {
namespace {

using test::chunks_of;
using test::noise;
using test::number_of;
using test::ramp;

Image8 stb_decoded(const std::string& png) {
  int width = 0, height = 0, channels = 0;
  const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
      stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(png.data()),
                            static_cast<int>(png.size()), &width, &height, &channels, 0),
      stbi_image_free);
  if (pixels == nullptr || channels != 3) return {};
  Image8 image(width, height);
  std::memcpy(image.rgb.data(), pixels.get(), image.rgb.size());
  return image;
}

void expect_same_pixels(const Image8& got, const Image8& expected) {
  ASSERT_EQ(got.width, expected.width);
  ASSERT_EQ(got.height, expected.height);
  EXPECT_TRUE(got.rgb == expected.rgb);
}

TEST(Png, AnIndependentDecoderReadsTheSamePixels) {
  const std::pair<int, int> sizes[] = {{1, 1},   {2, 1},   {1, 100},   {100, 1},  {333, 217},
                                       {31, 33}, {256, 3}, {640, 480}, {601, 701}};
  for (const auto& [width, height] : sizes) {
    SCOPED_TRACE(width);
    for (const Image8& image :
         {noise(width, height, 120), ramp(width, height), Image8(width, height)}) {
      expect_same_pixels(stb_decoded(encode_png(image)), image);
      expect_same_pixels(stb_decoded(encode_png(test::scanlines_of(image))), image);
    }
  }
}

TEST(Png, WithAlphaItsFourChannelsAreRead) {
  for (const auto& [w, h] : {std::pair{1, 1}, {31, 33}, {256, 3}}) {
    const Image8 codes = noise(w, 2 * h, 123);  // 6 w h of them
    const ImageRgba8 image{w, h, {codes.rgb.begin(), codes.rgb.begin() + 4 * w * h}};
    const std::string png = encode_png(image);
    int width = 0, height = 0, channels = 0;
    const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
        stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(png.data()),
                              static_cast<int>(png.size()), &width, &height, &channels, 0),
        stbi_image_free);
    ASSERT_NE(pixels, nullptr);
    ASSERT_EQ(std::tuple(width, height, channels), std::tuple(w, h, 4));
    EXPECT_EQ(std::memcmp(pixels.get(), image.rgba.data(), image.rgba.size()), 0);
    // W3C PNG (third edition), 11.2.1: 8 bits, RGBA.
    EXPECT_EQ(png.substr(24, 5), std::string("\x08\x06\0\0\0", 5));
  }
}

TEST(Png, LongestRowsAreRead) {
  expect_same_pixels(stb_decoded(encode_png(ramp(1'000'000, 1))), ramp(1'000'000, 1));
  expect_same_pixels(stb_decoded(encode_png(ramp(1, 100'000))), ramp(1, 100'000));
}

TEST(Png, HasOneHeaderItsPixelsAndAnEnd) {
  const auto chunks = chunks_of(encode_png(noise(333, 217, 121)));
  ASSERT_GE(chunks.size(), 3U);
  EXPECT_EQ(chunks.front().type, "IHDR");
  EXPECT_EQ(chunks.back().type, "IEND");
  EXPECT_TRUE(chunks.back().data.empty());
  for (std::size_t i = 1; i + 1 < chunks.size(); ++i) EXPECT_EQ(chunks[i].type, "IDAT");
  const std::string& header = chunks.front().data;
  ASSERT_EQ(header.size(), 13U);
  EXPECT_EQ(number_of(header), 333U);
  EXPECT_EQ(number_of(std::string_view(header).substr(4)), 217U);
  // 8 bits, RGB, the one compression, the one filter method, not interlaced.
  EXPECT_EQ(std::string_view(header).substr(8), std::string_view("\x08\x02\0\0\0", 5));
}

TEST(Png, SameImageGivesTheSameBytesOnEveryThread) {
  const Image8 image = ramp(333, 217);
  const std::string png = encode_png(image);
  EXPECT_EQ(encode_png(image), png);
  encode_png(noise(64, 64, 122));  // what came before leaves no trace
  EXPECT_EQ(encode_png(image), png);
  std::array<std::string, 4> elsewhere;
  {
    std::vector<std::jthread> threads;
    for (std::string& each : elsewhere) threads.emplace_back([&] { each = encode_png(image); });
  }
  for (const std::string& each : elsewhere) EXPECT_EQ(each, png);
}

TEST(Png, FlatPicturesAreSmall) { EXPECT_LT(encode_png(Image8(640, 480)).size(), 10'000U); }

TEST(Png, ToldToStopThereIsNone) {
  std::stop_source source;
  EXPECT_EQ(encode_png(ramp(64, 48), source.get_token()), encode_png(ramp(64, 48)));
  source.request_stop();
  EXPECT_THROW(encode_png(ramp(64, 48), source.get_token()), Stopped);
}

TEST(Png, EncoderNamesItselfAndTheFullVersionNamesIt) {
  EXPECT_EQ(png_encoder().find("libdeflate "), 0U);
  EXPECT_EQ(full_version().find(version() + "+"), 0U);
  EXPECT_EQ(full_version().find(' '), std::string::npos);
  EXPECT_NE(full_version().find(png_encoder().substr(png_encoder().find(' ') + 1)),
            std::string::npos);
}

}  // namespace
}  // namespace tia
