#include "core/film/scanlines.h"

#include <algorithm>
#include <array>

namespace tia {

void Scanlines::filter(int y) {
  constexpr std::uint8_t sub = 1;
  constexpr std::size_t pixel = 3, chunk = 64;
  std::uint8_t* const row = at(0, y);
  row[-1] = sub;
  // From the right, so that what is subtracted still is a code; by chunks, for vectors.
  std::size_t end = row_bytes() - 1;
  for (; end >= chunk + pixel; end -= chunk) {
    std::uint8_t* const to = row + end - chunk;
    const std::uint8_t* const before = to - pixel;
    std::array<std::uint8_t, chunk> differences;
    for (std::size_t i = 0; i < chunk; ++i)
      differences[i] = static_cast<std::uint8_t>(to[i] - before[i]);
    for (std::size_t i = 0; i < chunk; ++i) to[i] = differences[i];
  }
  for (; end > pixel; --end)
    row[end - 1] = static_cast<std::uint8_t>(row[end - 1] - row[end - 1 - pixel]);
}

Scanlines scanlines_of(const Image8& image, const Workers& workers) {
  constexpr int share = 64;
  Scanlines scanlines(image.width, image.height);
  const std::size_t codes = 3 * static_cast<std::size_t>(image.width);
  workers.for_each((image.height + share - 1) / share, [&](int i) {
    for (int y = i * share; y < std::min((i + 1) * share, image.height); ++y) {
      const auto row = static_cast<std::size_t>(y);
      std::copy_n(image.rgb.data() + row * codes, codes, scanlines.at(0, y));
      scanlines.filter(y);
    }
  });
  return scanlines;
}

}  // namespace tia
