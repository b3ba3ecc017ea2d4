// How far pictures are from each other: closed forms, and SSIM held against its definition.
#include "core/film/similarity.h"

#include <gtest/gtest.h>

#include "tests/core/support.h"

namespace tia {
namespace {

using test::Random;

Image white_noise(int width, int height, std::uint64_t seed) {
  Random random(seed);
  Image image(width, height);
  for (float& each : image.rgb) each = static_cast<float>(random.unit());
  return image;
}
double luma(const Image& image, int x, int y) {
  const float* const p = image.at(x, y);
  return 0.2126 * static_cast<double>(p[0]) + 0.7152 * static_cast<double>(p[1]) +
         0.0722 * static_cast<double>(p[2]);
}

// Wang et al. (2004), equations 13 to 16, window by window: the variances about the means.
double ssim_at(const Image& a, const Image& b, int cx, int cy) {
  double sum = 0, ma = 0, mb = 0, va = 0, vb = 0, cov = 0;
  const auto each = [&](const auto& use) {
    for (int y = -5; y <= 5; ++y)
      for (int x = -5; x <= 5; ++x)
        use(std::exp(-(x * x + y * y) / (2 * 1.5 * 1.5)), luma(a, cx + x, cy + y),
            luma(b, cx + x, cy + y));
  };
  each([&](double w, double la, double lb) { sum += w, ma += w * la, mb += w * lb; });
  ma /= sum, mb /= sum;
  each([&](double w, double la, double lb) {
    va += w / sum * (la - ma) * (la - ma), vb += w / sum * (lb - mb) * (lb - mb);
    cov += w / sum * (la - ma) * (lb - mb);
  });
  const double c1 = 1e-4, c2 = 9e-4;
  return (2 * ma * mb + c1) * (2 * cov + c2) / ((ma * ma + mb * mb + c1) * (va + vb + c2));
}

TEST(Similarity, OfAPictureToItselfIsOne) {
  const Image a = white_noise(20, 15, 1);
  const Similarity same = similarity_of(a, a, 0, nullptr).whole;
  EXPECT_EQ(same.mse, 0);
  EXPECT_EQ(same.max, 0);
  EXPECT_EQ(same.psnr_db(), std::nullopt);
  EXPECT_NEAR(*same.ssim, 1, 1e-12);
}

TEST(Similarity, OfAShiftIsItsSquareAndTenDecibelsATenth) {
  Image a(30, 20), b(30, 20);
  std::ranges::fill(a.rgb, 0.5F);
  std::ranges::fill(b.rgb, 0.75F);
  const Similarity far = similarity_of(a, b, 0, nullptr).whole;
  EXPECT_EQ(far.mse, 0.0625);
  EXPECT_EQ(far.max, 0.25);
  EXPECT_NEAR(*far.psnr_db(), 10 * std::log10(1 / 0.0625), 1e-9);
  // Without any variance the luminance term is all there is.
  EXPECT_NEAR(*far.ssim, (2 * 0.5 * 0.75 + 1e-4) / (0.25 + 0.5625 + 1e-4), 1e-7);
}

TEST(Similarity, IsWangsIndexOfTheWholeAndOfClasses) {
  const Image a = white_noise(33, 21, 2);
  Image b = a;
  const Image other = white_noise(33, 21, 3);
  for (std::size_t i = 0; i < b.rgb.size(); ++i) b.rgb[i] = 0.7F * b.rgb[i] + 0.3F * other.rgb[i];
  const auto half = [](int x, int y) { return x + y < 25 ? 0 : 1; };
  double sums[2] = {}, squares[2] = {};
  int windows[2] = {}, pixels[2] = {};
  for (int y = 0; y < 21; ++y)
    for (int x = 0; x < 33; ++x) {
      const auto k = static_cast<std::size_t>(half(x, y));
      ++pixels[k];
      for (int c = 0; c < 3; ++c)
        squares[k] += std::pow(static_cast<double>(a.at(x, y)[c] - b.at(x, y)[c]), 2);
      if (x < 5 || x >= 28 || y < 5 || y >= 16) continue;
      ++windows[k];
      sums[k] += ssim_at(a, b, x, y);
    }
  const Similarities all = similarity_of(a, b, 2, half);
  EXPECT_NEAR(*all.whole.ssim, (sums[0] + sums[1]) / (windows[0] + windows[1]), 1e-9);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_NEAR(*all.classes[k].ssim, sums[k] / windows[k], 1e-9);
    EXPECT_NEAR(all.classes[k].mse, squares[k] / (3 * pixels[k]), 1e-8);
    EXPECT_EQ(all.classes[k].pixels, pixels[k]);
  }
}

TEST(Similarity, OfPicturesSmallerThanAWindowHasNoIndex) {
  const Similarity of =
      similarity_of(white_noise(10, 40, 4), white_noise(10, 40, 5), 0, nullptr).whole;
  EXPECT_EQ(of.ssim, std::nullopt);
  EXPECT_GT(of.mse, 0);
}

}  // namespace
}  // namespace tia
