#include "core/video/ycbcr.h"

#include <algorithm>

namespace tia {
namespace {

constexpr double kr = 0.2126, kb = 0.0722;
constexpr int unit = 1 << 16;

constexpr int rounded(double x) { return static_cast<int>(x < 0 ? x - 0.5 : x + 0.5); }

/// Weights of R', G' and B', in 1/unit; and what stands for none of them.
struct Weights {
  int r, g, b, zero;
  // The sum of so many pixels' codes.
  std::uint8_t of(int red, int green, int blue, int pixels) const {
    const std::int64_t sum =
        std::int64_t{r} * red + std::int64_t{g} * green + std::int64_t{b} * blue;
    const std::int64_t one = std::int64_t{unit} * pixels;
    return static_cast<std::uint8_t>((sum + one * zero + one / 2) / one);
  }
};
// The last weight makes the sum exact: 219/255, and 0 of what differs from grey.
constexpr Weights luma = [] {
  const double scale = 219.0 / 255 * unit;
  const int r = rounded(kr * scale), b = rounded(kb * scale);
  return Weights{r, rounded(scale) - r - b, b, 16};
}();
constexpr Weights blueness = [] {
  const double scale = 224.0 / 255 * unit / (2 * (1 - kb));
  const int r = rounded(-kr * scale), g = rounded(-(1 - kr - kb) * scale);
  return Weights{r, g, -r - g, 128};
}();
constexpr Weights redness = [] {
  const double scale = 224.0 / 255 * unit / (2 * (1 - kr));
  const int g = rounded(-(1 - kr - kb) * scale), b = rounded(-kb * scale);
  return Weights{-g - b, g, b, 128};
}();

void convert_colors(const Image8& image, YCbCr420& to) {
  const auto row = static_cast<std::size_t>(image.width) * 3;
  std::size_t i = 0;
  for (int y = 0; y < image.height; y += 2)
    for (int x = 0; x < image.width; x += 2, ++i) {
      std::array<int, 3> sum{};
      int pixels = 0;
      for (int v = y; v < std::min(y + 2, image.height); ++v)
        for (int u = x; u < std::min(x + 2, image.width); ++u, ++pixels) {
          const std::uint8_t* rgb = image.rgb.data() + static_cast<std::size_t>(v) * row +
                                    static_cast<std::size_t>(u) * 3;
          for (std::size_t c = 0; c < 3; ++c) sum[c] += rgb[c];
        }
      to.cb[i] = blueness.of(sum[0], sum[1], sum[2], pixels);
      to.cr[i] = redness.of(sum[0], sum[1], sum[2], pixels);
    }
}

}  // namespace

YCbCr420 ycbcr_of(const Image8& image) {
  YCbCr420 to{image.width, image.height, {}, {}, {}};
  to.y.resize(image.rgb.size() / 3);
  const std::size_t colors =
      static_cast<std::size_t>(to.half_width()) * static_cast<std::size_t>(to.half_height());
  to.cb.resize(colors);
  to.cr.resize(colors);
  const std::uint8_t* rgb = image.rgb.data();
  for (std::uint8_t& code : to.y) {
    code = luma.of(rgb[0], rgb[1], rgb[2], 1);
    rgb += 3;
  }
  convert_colors(image, to);
  return to;
}

}  // namespace tia
