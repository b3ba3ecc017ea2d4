#include "core/film/film.h"

#include <cstring>

namespace tia {

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
  if (rule_.shown == Shown::light) return develop(block);
  Block shown = block;
  show(rule_.shown, shown);
  develop(shown);
}

void DisplayFilm::develop(const Block& block) {
  const std::size_t row_bytes = 3 * static_cast<std::size_t>(image_.width);
  for (int y = 0; y < block.height; ++y) {
    std::array<std::uint8_t, row_codes> codes;
    develop_row(block, y, rule_.curve(), codes);
    std::uint8_t* to = image_.rgb.data() + static_cast<std::size_t>(block.y + y) * row_bytes +
                       3 * static_cast<std::size_t>(block.x);
    std::memcpy(to, codes.data(), 3 * static_cast<std::size_t>(block.width));
  }
}

}  // namespace tia
