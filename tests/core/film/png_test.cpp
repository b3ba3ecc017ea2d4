// PNG files read back by stb_image, which shares nothing with the encoder's compressor; the
// container's chunks and checksums by a reader of our own.
#include "core/film/png.h"

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <memory>
#include <string_view>
#include <thread>

#include "core/input/stopped.h"
#include "tests/core/support.h"

#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#include <stb/stb_image.h>

namespace tia {
namespace {

using test::Random;

Image8 decoded(const std::string& png) {
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

std::uint32_t big_endian(std::string_view bytes) {
  std::uint32_t value = 0;
  for (const char c : bytes.substr(0, 4)) value = value << 8U | static_cast<unsigned char>(c);
  return value;
}

// PNG (third edition), annex D: CRC-32, bit by bit.
std::uint32_t crc(std::string_view bytes) {
  std::uint32_t c = 0xFFFFFFFFU;
  for (const char byte : bytes) {
    c ^= static_cast<unsigned char>(byte);
    for (int k = 0; k < 8; ++k) c = (c & 1U) != 0 ? 0xEDB88320U ^ (c >> 1U) : c >> 1U;
  }
  return c ^ 0xFFFFFFFFU;
}

struct Chunk {
  std::string type, data;
};

// The chunks after the signature; a test failure where the layout or a checksum is wrong.
std::vector<Chunk> chunks_of(const std::string& png) {
  std::vector<Chunk> chunks;
  std::string_view rest = png;
  EXPECT_EQ(rest.substr(0, 8), "\x89PNG\r\n\x1A\n");
  rest.remove_prefix(8);
  while (rest.size() >= 12) {
    const std::size_t length = big_endian(rest);
    if (rest.size() < 12 + length) break;
    EXPECT_EQ(big_endian(rest.substr(8 + length)), crc(rest.substr(4, 4 + length)));
    chunks.push_back({std::string(rest.substr(4, 4)), std::string(rest.substr(8, length))});
    rest.remove_prefix(12 + length);
  }
  EXPECT_TRUE(rest.empty()) << "bytes after the last chunk";
  return chunks;
}

Image8 noise(int width, int height, std::uint64_t seed) {
  Random random(seed);
  Image8 image(width, height);
  for (auto& code : image.rgb) code = static_cast<std::uint8_t>(random.below(256));
  return image;
}
Image8 ramp(int width, int height) {
  Image8 image(width, height);
  for (std::size_t i = 0; i < image.rgb.size(); ++i)
    image.rgb[i] = static_cast<std::uint8_t>(i / 3 + i % 3 * 40);
  return image;
}

void expect_same(const Image8& got, const Image8& expected) {
  ASSERT_EQ(got.width, expected.width);
  ASSERT_EQ(got.height, expected.height);
  EXPECT_TRUE(got.rgb == expected.rgb);
}

TEST(Png, AnIndependentDecoderReadsTheSamePixels) {
  const std::pair<int, int> sizes[] = {{1, 1},     {2, 1},   {1, 100}, {100, 1},
                                       {333, 217}, {31, 33}, {256, 3}, {640, 480}};
  for (const auto& [width, height] : sizes) {
    SCOPED_TRACE(width);
    expect_same(decoded(encode_png(noise(width, height, 120))), noise(width, height, 120));
    expect_same(decoded(encode_png(ramp(width, height))), ramp(width, height));
    expect_same(decoded(encode_png(Image8(width, height))), Image8(width, height));
  }
}

TEST(Png, LongestRowsAreRead) {
  expect_same(decoded(encode_png(ramp(1'000'000, 1))), ramp(1'000'000, 1));
  expect_same(decoded(encode_png(ramp(1, 100'000))), ramp(1, 100'000));
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
  EXPECT_EQ(big_endian(header), 333U);
  EXPECT_EQ(big_endian(std::string_view(header).substr(4)), 217U);
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
