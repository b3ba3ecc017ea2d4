// WebP files put together here bit by bit, and by libwebp's encoder.
#include "core/models/webp.h"

#include <gmock/gmock.h>
#include <webp/encode.h>

#include <cstdlib>
#include <memory>

#include "tests/core/models/webp_files.h"

namespace tia {
namespace {

using test::Bytes;
using test::Random;

constexpr test::WebpColors colors{10, 20, 200, 30, 40};

ImageRgba8 webp_image(const Bytes& file) {
  const auto result = decode_webp(file);
  if (const auto* fault = std::get_if<PictureFault>(&result)) {
    ADD_FAILURE() << fault->got << ", allowed: " << fault->allowed;
    return {};
  }
  return std::get<ImageRgba8>(result);
}
PictureFault webp_refusal(const Bytes& file, const PictureLimits& limits = {}) {
  const auto result = decode_webp(file, limits);
  const auto* fault = std::get_if<PictureFault>(&result);
  return fault != nullptr ? *fault : PictureFault{};
}

TEST(Webp, LosslessPixelsComeBackRowByRow) {
  const ImageRgba8 image = webp_image(test::lossless_webp(3, 2, colors, "010110"));
  EXPECT_EQ(image.width, 3);
  EXPECT_EQ(image.height, 2);
  Bytes expected;
  for (const char pixel : std::string("010110"))
    for (const int code : {10, pixel == '1' ? 200 : 20, 30, 40})
      expected.push_back(static_cast<std::uint8_t>(code));
  EXPECT_EQ(image.rgba, expected);
}

struct FreeWebp {
  void operator()(std::uint8_t* p) const { WebPFree(p); }
};
Bytes encoded(const Bytes& rgba, int width, int height, float quality) {
  std::uint8_t* out = nullptr;
  const std::size_t size = WebPEncodeRGBA(rgba.data(), width, height, 4 * width, quality, &out);
  const std::unique_ptr<std::uint8_t, FreeWebp> owner(out);
  return {out, out + size};
}
Bytes slope(int width, int height) {
  Bytes rgba;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (const int code : {4 * x, 4 * y, 128, 255 - 2 * x})
        rgba.push_back(static_cast<std::uint8_t>(code));
  return rgba;
}

TEST(Webp, LossyPicturesComeBackNearly) {
  const Bytes rgba = slope(40, 30);
  const ImageRgba8 image = webp_image(encoded(rgba, 40, 30, 100));
  ASSERT_EQ(image.rgba.size(), rgba.size());
  for (std::size_t i = 0; i < rgba.size(); ++i)
    EXPECT_NEAR(image.rgba[i], rgba[i], i % 4 == 3 ? 0 : 16);
}

TEST(Webp, ItsHeaderIsMeasuredAlone) {
  const Bytes file = test::lossless_webp(16384, 16384, colors, "");
  const auto measured = measure_webp(file, {1 << 20, std::int64_t{1} << 28});
  ASSERT_TRUE(std::holds_alternative<PictureSize>(measured));
  EXPECT_EQ(std::get<PictureSize>(measured).width, 16384);
  EXPECT_EQ(std::get<PictureSize>(measured).scanned_pixels(), std::int64_t{1} << 28);
  EXPECT_TRUE(webp_refusal(file, {1 << 20, (1 << 28) - 1}).beyond_limits);
  EXPECT_EQ(webp_refusal(file).got, "16384 x 16384 pixels");
  EXPECT_EQ(webp_refusal(file, {10, 1 << 20}).allowed, "a picture of at most 10 bytes");
}

TEST(Webp, AnimationsAreRefused) {
  std::string head(10, '\0');
  head[0] = 2;
  const Bytes file = test::webp_file(
      test::riff_chunk("VP8X", head) + test::riff_chunk("ANIM", std::string(6, '\0')) +
      test::riff_chunk("ANMF",
                       std::string(16, '\0') +
                           test::riff_chunk("VP8L", test::lossless_stream(1, 1, colors, "0"))));
  EXPECT_EQ(webp_refusal(file).got, "an animation");
}

// libwebp reads bits beyond the end as 0: a few of the last bytes may be missing.
TEST(Webp, EveryStartIsRefusedOrWhole) {
  for (const Bytes& file :
       {test::lossless_webp(3, 2, colors, "010110"), encoded(slope(20, 10), 20, 10, 80)}) {
    const Bytes rgba = webp_image(file).rgba;
    int refused = 0;
    for (std::size_t length = 0; length < file.size(); ++length) {
      const Bytes start(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(length));
      const auto result = decode_webp(start);
      const auto* image = std::get_if<ImageRgba8>(&result);
      refused += image == nullptr ? 1 : 0;
      if (image != nullptr) {
        EXPECT_EQ(image->rgba, rgba) << length;
      }
    }
    EXPECT_GE(refused, static_cast<int>(file.size()) - 4);
  }
}

TEST(Webp, WhatIsNoWebpIsRefused) {
  EXPECT_FALSE(is_webp({}));
  EXPECT_FALSE(is_webp(test::to_bytes("RIFF....WAVE")));
  EXPECT_TRUE(is_webp(test::to_bytes("RIFF....WEBP")));
  EXPECT_THAT(webp_refusal({}).allowed, testing::HasSubstr("a whole WebP picture"));
  EXPECT_FALSE(webp_refusal(test::to_bytes("RIFF....WEBP")).beyond_limits);
  EXPECT_EQ(webp_refusal(test::to_bytes(test::lossless_stream(1, 1, colors, "0"))).got,
            "bytes that begin otherwise");
}

TEST(Webp, DamagedFilesAreTheSameEachTime) {
  Random random(340);
  const Bytes files[] = {test::lossless_webp(3, 2, colors, "010110"),
                         encoded(slope(20, 10), 20, 10, 80)};
  for (int i = 0; i < 2000; ++i) {
    Bytes file = files[i % 2];
    for (int changes = 1 + random.below(4); changes > 0; --changes)
      file[12 + static_cast<std::size_t>(random.below(static_cast<int>(file.size()) - 12))] =
          static_cast<std::uint8_t>(random.below(256));
    const PictureLimits small{1 << 20, 1 << 14};
    const auto first = decode_webp(file, small), second = decode_webp(file, small);
    ASSERT_EQ(first.index(), second.index());
    if (const auto* image = std::get_if<ImageRgba8>(&first)) {
      ASSERT_EQ(image->rgba, std::get<ImageRgba8>(second).rgba);
    }
  }
}

}  // namespace
}  // namespace tia
