// Radiance's pictures, read by a reader of our own.
#include "core/film/hdr.h"

#include <gtest/gtest.h>

#include "core/parallel/stopped.h"
#include "tests/core/film/radiance_reader.h"
#include "tests/core/support.h"

namespace tia::test {
namespace {

Image of_one_pixel(float r, float g, float b) {
  Image image(1, 1);
  image.rgb = {r, g, b};
  return image;
}

Rgbe pixel_of(float r, float g, float b) {
  return read_radiance(encode_hdr(of_one_pixel(r, g, b))).at(0, 0);
}

TEST(Hdr, BytesOfAPictureAreTheFormats) {
  Image image(2, 2);  // 1 is 128/256 of 2^1, 3 is 192/256 of 2^2
  image.rgb = {1, 0.5F, 0.25F, 0, 0, 0, 3, 0, 0, 0.75F, 0.75F, 0.75F};
  const std::string file = encode_hdr(image);
  EXPECT_TRUE(file.starts_with("#?RADIANCE\n"));
  const std::string tail = "\n\n-Y 2 +X 2\n";
  const std::size_t rows = file.find(tail) + tail.size();
  const std::string pixels{'\x80', '\x40', '\x20', '\x81', 0,      0,      0,      0,
                           '\xC0', 0,      0,      '\x82', '\xC0', '\xC0', '\xC0', '\x80'};
  EXPECT_EQ(file.substr(rows), pixels);
}

// A picture with runs, of components of all sizes, some of them 0.
Image random_picture(Random& random, int width, int height) {
  Image image(width, height);
  const double usual = random.in(-20, 20);
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
    const bool repeats = i > 0 && random.chance(0.7);
    const double size = random.chance(0.5) ? usual : random.in(-100, 126);
    for (std::size_t c = i; c < i + 3; ++c) {
      const double component = random.chance(0.1) ? 0 : std::exp2(size) * random.unit();
      image.rgb[c] = repeats ? image.rgb[c - 3] : static_cast<float>(component);
    }
  }
  return image;
}

// With 2^(e-1) <= M < 2^e for the largest component M, mantissas are whole multiples of 2^(e-8),
// rounded down. Ward reads half a multiple more: at most 2^(e-9) off, which is at most M / 256.
void expect_close(const Image& image, const RadiancePicture& read) {
  ASSERT_EQ(read.width, image.width);
  ASSERT_EQ(read.height, image.height);
  for (std::size_t i = 0; i < read.pixels.size(); ++i) {
    const float* const rgb = &image.rgb[3 * i];
    const double largest = std::max({rgb[0], rgb[1], rgb[2]});
    const Rgbe& pixel = read.pixels[i];
    if (largest < 1e-32F) {
      ASSERT_EQ(pixel, Rgbe{});
      continue;
    }
    for (std::size_t c = 0; c < 3; ++c) {
      ASSERT_EQ(pixel[c], std::floor(rgb[c] / step_of(pixel)));
      ASSERT_LE(std::fabs(component_of(pixel, c) - rgb[c]), largest / 256);
    }
    ASSERT_GE(std::max({pixel[0], pixel[1], pixel[2]}), 128);
  }
}

TEST(Hdr, IsReadAgainToOnePartIn256OfThePixelsLargestComponent) {
  Random random(91);
  for (const int width : {1, 2, 7, 8, 9, 126, 127, 128, 129, 130, 255, 256, 257, 640, 32767, 32768})
    for (int turn = 0; turn < 5; ++turn) {
      SCOPED_TRACE(width);
      const Image image = random_picture(random, width, random.whole(1, 5));
      expect_close(image, read_radiance(encode_hdr(image)));
    }
}

TEST(Hdr, EveryPowerOfTwoAndItsNeighboursHaveTheirExponent) {
  for (int exponent = -105; exponent < 127; ++exponent) {
    const float power = std::ldexp(1.0F, exponent);
    for (const float value : {std::nextafter(power, 0.0F), power, std::nextafter(power, 2 * power)})
      expect_close(of_one_pixel(value, value / 2, 0),
                   read_radiance(encode_hdr(of_one_pixel(value, value / 2, 0))));
  }
}

TEST(Hdr, BlackIsExactlyBlack) {
  const RadiancePicture black = read_radiance(encode_hdr(Image(640, 3)));
  for (const Rgbe& pixel : black.pixels) {
    EXPECT_EQ(pixel, Rgbe{});
    EXPECT_EQ(component_of(pixel, 0), 0);
  }
}

TEST(Hdr, WhatRgbeCannotHoldIsTheNearestThatItCan) {
  const float inf = std::numeric_limits<float>::infinity();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float most = std::numeric_limits<float>::max();
  EXPECT_EQ(pixel_of(inf, most, largest_rgbe), (Rgbe{255, 255, 255, 255}));
  EXPECT_EQ(pixel_of(1e6F, -1e6F, nan), (Rgbe{244, 0, 0, 148}));  // 1e6 is 244.1/256 of 2^20
  EXPECT_EQ(pixel_of(-inf, -0.0F, 1e-40F), Rgbe{});
}

TEST(Hdr, RowsRunFromTheTopAndFromTheLeft) {
  Image image(9, 2);
  image.at(0, 0)[0] = 1;
  image.at(8, 1)[2] = 1;
  const RadiancePicture read = read_radiance(encode_hdr(image));
  EXPECT_EQ(read.at(0, 0), (Rgbe{128, 0, 0, 129}));
  EXPECT_EQ(read.at(8, 1), (Rgbe{0, 0, 128, 129}));
}

TEST(Hdr, APlaneOfEqualBytesTakesTwoForEach127) {
  const std::size_t row = 4 + 4 * 2 * 6;  // four marks, and six runs of 127 or less for each plane
  const std::size_t head = encode_hdr(Image(640, 1)).size() - row;
  EXPECT_EQ(encode_hdr(Image(640, 480)).size(), head + 2 + 480 * row);  // "480" for "1"
}

TEST(Hdr, IsNotBegunWhereItIsToStop) {
  std::stop_source source;
  source.request_stop();
  EXPECT_THROW(encode_hdr(Image(1, 1), source.get_token()), Stopped);
}

}  // namespace
}  // namespace tia::test
