// JPEG out, read by stb_image, which shares nothing with libjpeg.
#include "core/film/jpeg.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/film/decode.h"
#include "tests/core/film/files.h"

namespace tia::test {
namespace {

Image8 read_back(const std::string& file) {
  return std::get<Image8>(decode_picture(to_bytes(file)));
}

// A picture whose codes run evenly from corner to corner, differently in each colour.
Image8 ramps(int width, int height, std::array<double, 9> by) {
  Image8 image(width, height);
  std::size_t i = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (std::size_t c = 0; c < 9; c += 3)
        image.rgb[i++] = static_cast<std::uint8_t>(
            127.5 * (1 + std::sin(by[c] * x + by[c + 1] * y + by[c + 2])));
  return image;
}

// Of a flat picture there is in each block its mean alone, in steps of 3 and 3.4 eighths of a code
// (T.81, tables K.1 and K.2, of 16 and 17, at quality 90 a fifth): that is off by 0.2 codes at
// most; and what is rounded on the way there and back.
TEST(Jpeg, OfOneColorIsThatColor) {
  std::mt19937 random(1);
  for (int i = 0; i < 100; ++i) {
    Image8 image(static_cast<int>(1 + random() % 20), static_cast<int>(1 + random() % 20));
    std::array<std::uint8_t, 3> color{};
    for (std::uint8_t& each : color) each = static_cast<std::uint8_t>(random() % 256);
    for (std::size_t k = 0; k < image.rgb.size(); ++k) image.rgb[k] = color[k % 3];
    const Image8 back = read_back(encode_jpeg(image));
    ASSERT_EQ(back.width, image.width);
    ASSERT_EQ(back.height, image.height);
    for (std::size_t k = 0; k < image.rgb.size(); ++k)
      ASSERT_NEAR(back.rgb[k], image.rgb[k], 3) << k;
  }
}

// Of waves of 60 pixels and longer a block is a plane and a little more: few numbers are rounded.
TEST(Jpeg, OfSmoothPicturesIsWithinAMeanOf1Point5) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> slope(-0.1, 0.1);
  for (int i = 0; i < 20; ++i) {
    std::array<double, 9> by{};
    for (double& each : by) each = slope(random);
    const Image8 image =
        ramps(static_cast<int>(8 + random() % 90), static_cast<int>(8 + random() % 90), by);
    const Image8 back = read_back(encode_jpeg(image));
    ASSERT_EQ(back.rgb.size(), image.rgb.size());
    double off = 0;
    for (std::size_t k = 0; k < image.rgb.size(); ++k) off += std::abs(back.rgb[k] - image.rgb[k]);
    EXPECT_LT(off / static_cast<double>(image.rgb.size()), 1.5) << i;
  }
}

// What every decoder has: the frame is a baseline one (SOF0), of 8 bits, its three components at
// every pixel. Source: T.81, B.2.2.
TEST(Jpeg, IsABaselineFileOfThreeComponentsAtEveryPixel) {
  const std::string file = encode_jpeg(Image8(258, 3));
  EXPECT_EQ(file.substr(0, 4), "\xFF\xD8\xFF\xE0");
  EXPECT_EQ(file.substr(6, 5), std::string("JFIF\0", 5));
  EXPECT_TRUE(file.ends_with("\xFF\xD9"));
  const std::string frame(
      "\xFF\xC0\x00\x11\x08\x00\x03\x01\x02\x03\x01\x11\x00\x02\x11\x01\x03\x11\x01", 19);
  EXPECT_NE(file.find(frame), file.npos);
}

// Chance does not compress: longer than what is foreseen.
TEST(Jpeg, OfNoiseGrowsAsFarAsItMust) {
  std::mt19937 random(3);
  Image8 image(200, 100);
  for (std::uint8_t& code : image.rgb) code = static_cast<std::uint8_t>(random());
  const std::string file = encode_jpeg(image);
  EXPECT_GT(file.size(), 2 * (image.rgb.size() / 8 + 4096));
  EXPECT_EQ(read_back(file).rgb.size(), image.rgb.size());
  EXPECT_EQ(encode_jpeg(image), file);
}

}  // namespace
}  // namespace tia::test
