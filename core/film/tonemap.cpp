#include "core/film/tonemap.h"

#include <bit>
#include <cstring>

#include "core/math/lanes.h"

namespace tia {
namespace {

// NaN becomes 0: the maximum's second argument.
template <class Real>
Real scaled(Real light) {
  return min_of(max_of(light, Real(0)), Real(1)) * Real(255) + Real(0.5F);
}

// Drops the fourth byte of each of four pixels.
using FourPixels [[gnu::vector_size(16)]] = std::uint8_t;
void store_rgb(FourPixels rgbx, std::uint8_t* to) {
  const FourPixels rgb =
      __builtin_shufflevector(rgbx, rgbx, 0, 1, 2, 4, 5, 6, 8, 9, 10, 12, 13, 14, 0, 0, 0, 0);
  std::memcpy(to, &rgb, sizeof rgb);
}

void develop_linear(const float* r, const float* g, const float* b, std::uint8_t* to) {
  constexpr std::size_t n = Wide::size;
  for (std::size_t x = 0; x < FilmTile::size; x += n) {
    const auto code = [x](const float* plane) {
      return to_int(scaled(Wide::load_unaligned(plane + x)));
    };
    const WideInt rgbx = code(r) | (code(g) << 8) | (code(b) << 16);
    std::array<FourPixels, n / 4> pixels;
    std::memcpy(&pixels, &rgbx, sizeof pixels);
    for (std::size_t i = 0; i < n / 4; ++i) store_rgb(pixels[i], to + 3 * (x + 4 * i));
  }
}

// ---- sRGB ---------------------------------------------------------------------------------

// x^(1/5) by Newton's method: the iterates fall towards the root; stops when they no longer do.
double fifth_root(double x) {
  double y = 1;  // x <= 1, so the start lies above the root
  for (;;) {
    const double y4 = y * y * y * y;
    const double next = (4 * y + x / y4) / 5;
    if (!(next < y)) return y;
    y = next;
  }
}

// The light from which on each code is the nearest, and for each range of floats that share their
// exponent and 7 bits of mantissa the code at its start: at most one threshold falls inside.
struct SrgbTable {
  static constexpr int shift = 23 - 7;
  static constexpr std::uint32_t first = (127U - 13U) << 7U;  // 2^-13: still code 0
  static constexpr std::uint32_t last = 127U << 7U;           // 1
  std::array<float, 257> threshold{};
  std::array<std::uint8_t, last - first> code_at_start{};

  SrgbTable() {
    for (std::size_t k = 1; k < 256; ++k)
      threshold[k] = round_up(srgb_to_linear((static_cast<double>(k) - 0.5) / 255));
    threshold[256] = infinity;
    std::size_t code = 0;
    for (std::uint32_t i = first; i < last; ++i) {
      const float start = std::bit_cast<float>(i << shift);
      while (start >= threshold[code + 1]) ++code;
      code_at_start[i - first] = static_cast<std::uint8_t>(code);
    }
  }

  static float round_up(double x) {
    const auto f = static_cast<float>(x);
    return static_cast<double>(f) < x ? std::bit_cast<float>(std::bit_cast<std::uint32_t>(f) + 1)
                                      : f;
  }
};
const SrgbTable srgb;

}  // namespace

double srgb_to_linear(double signal) {
  if (signal <= 0.04045) return signal / 12.92;
  const double base = (signal + 0.055) / 1.055;
  const double fifth = fifth_root(base);
  return base * base * (fifth * fifth);  // base^2.4 = base^2 * (base^(1/5))^2
}

std::uint8_t encode_linear(float light) { return static_cast<std::uint8_t>(scaled(light)); }

std::uint8_t encode_srgb(float light) {
  if (!(light >= std::bit_cast<float>(SrgbTable::first << SrgbTable::shift))) return 0;
  if (light >= 1) return 255;
  const std::uint32_t i = std::bit_cast<std::uint32_t>(light) >> SrgbTable::shift;
  const std::size_t code = srgb.code_at_start[i - SrgbTable::first];
  return static_cast<std::uint8_t>(code + (light >= srgb.threshold[code + 1] ? 1 : 0));
}

void develop_row(const FilmTile& tile, int y, Encoding encoding,
                 std::span<std::uint8_t, row_codes> codes) {
  const std::size_t row = static_cast<std::size_t>(y) * FilmTile::size;
  if (encoding == Encoding::linear)
    return develop_linear(&tile.r[row], &tile.g[row], &tile.b[row], codes.data());
  for (std::size_t x = 0; x < static_cast<std::size_t>(tile.width); ++x) {
    codes[3 * x] = encode_srgb(tile.r[row + x]);
    codes[3 * x + 1] = encode_srgb(tile.g[row + x]);
    codes[3 * x + 2] = encode_srgb(tile.b[row + x]);
  }
}

}  // namespace tia
