// BT.709's codes against its formulas in double.
#include "core/video/ycbcr.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/film/png_chunks.h"

namespace tia::test {
namespace {

struct Codes {
  double y, cb, cr;
};

// Source: ITU-R BT.709-6 (2015), table 3: luma, differences, and their quantisation in 8 bits.
Codes codes_of(double r, double g, double b) {
  const double luma = (0.2126 * r + 0.7152 * g + 0.0722 * b) / 255;
  return {16 + 219 * luma, 128 + 224 * (b / 255 - luma) / 1.8556,
          128 + 224 * (r / 255 - luma) / 1.5748};
}

TEST(Bt709, IsBt709ToHalfACode) {
  const Image8 image = noise(7, 5, 1);
  const YCbCr420 made = ycbcr_of(image);
  const auto code = [&](int x, int y, std::size_t c) {
    return static_cast<double>(image.rgb[static_cast<std::size_t>(y * 7 + x) * 3 + c]);
  };
  for (int y = 0; y < 5; ++y)
    for (int x = 0; x < 7; ++x)
      EXPECT_NEAR(made.y[static_cast<std::size_t>(y * 7 + x)],
                  codes_of(code(x, y, 0), code(x, y, 1), code(x, y, 2)).y, 0.51);
  ASSERT_EQ(made.cb.size(), 4U * 3);
  for (int v = 0; v < 3; ++v)
    for (int u = 0; u < 4; ++u) {
      std::array<double, 3> mean{};
      int pixels = 0;
      for (int y = 2 * v; y < std::min(2 * v + 2, 5); ++y)
        for (int x = 2 * u; x < std::min(2 * u + 2, 7); ++x, ++pixels)
          for (std::size_t c = 0; c < 3; ++c) mean[c] += code(x, y, c);
      const Codes codes = codes_of(mean[0] / pixels, mean[1] / pixels, mean[2] / pixels);
      EXPECT_NEAR(made.cb[static_cast<std::size_t>(v * 4 + u)], codes.cb, 0.51);
      EXPECT_NEAR(made.cr[static_cast<std::size_t>(v * 4 + u)], codes.cr, 0.51);
    }
}

TEST(Bt709, OfGreyIsGreyExactly) {
  for (int grey = 0; grey < 256; ++grey) {
    Image8 image(1, 1);
    image.rgb.assign(3, static_cast<std::uint8_t>(grey));
    const YCbCr420 made = ycbcr_of(image);
    EXPECT_EQ(made.y[0], std::lround(16 + 219 * grey / 255.0));
    EXPECT_EQ(made.cb[0], 128);
    EXPECT_EQ(made.cr[0], 128);
  }
}

}  // namespace
}  // namespace tia::test
