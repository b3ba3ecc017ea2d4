#include "core/film/film.h"

#include <cstring>

namespace tia {
namespace {

// Codes of linear light or of what show has made.
void develop_rows(const DisplayRule& rule, const Block& block, std::uint8_t* to,
                  std::size_t row_bytes) {
  for (int y = 0; y < block.height; ++y, to += row_bytes) {
    std::array<std::uint8_t, row_codes> codes;
    develop_row(block, y, rule.curve(), codes);
    std::memcpy(to, codes.data(), 3 * static_cast<std::size_t>(block.width));
  }
}

void develop(const DisplayRule& rule, const Block& block, std::uint8_t* to, std::size_t row_bytes) {
  if (rule.shown == FeatureDisplay::light) return develop_rows(rule, block, to, row_bytes);
  Block shown = block;
  show(rule.shown, shown);
  develop_rows(rule, shown, to, row_bytes);
}

}  // namespace

void LinearFilm::put(const Block& block) {
  for (int y = 0; y < block.height; ++y) {
    float* to = image_.at(block.x, block.y + y);
    const std::size_t row = static_cast<std::size_t>(y) * Block::size;
    for (std::size_t i = row; i < row + static_cast<std::size_t>(block.width); ++i) {
      *to++ = block.r[i];
      *to++ = block.g[i];
      *to++ = block.b[i];
    }
  }
}

void DisplayFilm::put(const Block& block) {
  const std::size_t row_bytes = 3 * static_cast<std::size_t>(image_.width);
  std::uint8_t* const to = image_.rgb.data() + static_cast<std::size_t>(block.y) * row_bytes +
                           3 * static_cast<std::size_t>(block.x);
  develop(rule_, block, to, row_bytes);
}

void ScanlineFilm::put(const Block& block) {
  develop(rule_, block, scanlines_.at(block.x, block.y), scanlines_.row_bytes());
  // Acquire and release: the thread that completes the band sees all pixels that others have put.
  std::atomic<int>& come = come_[static_cast<std::size_t>(block.y)];
  const int before = come.fetch_add(block.width, std::memory_order_acq_rel);
  if (before + block.width < scanlines_.width()) return;
  for (int y = block.y; y < block.y + block.height; ++y) scanlines_.filter(y);
}

}  // namespace tia
