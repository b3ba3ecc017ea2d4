#include "core/film/film.h"

#include <cstring>

namespace tia {
namespace {

// Codes of linear light or of what show has made.
void develop_rows(const DisplayRule& rule, const FilmTile& tile, std::uint8_t* to,
                  std::size_t row_bytes) {
  for (int y = 0; y < tile.height; ++y, to += row_bytes) {
    std::array<std::uint8_t, row_codes> codes;
    develop_row(tile, y, rule.curve(), codes);
    std::memcpy(to, codes.data(), 3 * static_cast<std::size_t>(tile.width));
  }
}

void develop(const DisplayRule& rule, const FilmTile& tile, std::uint8_t* to,
             std::size_t row_bytes) {
  if (rule.shown == FeatureDisplay::light) return develop_rows(rule, tile, to, row_bytes);
  FilmTile shown = tile;
  show(rule.shown, shown);
  develop_rows(rule, shown, to, row_bytes);
}

}  // namespace

void LinearFilm::put(const FilmTile& tile) {
  for (int y = 0; y < tile.height; ++y) {
    float* to = image_.at(tile.x, tile.y + y);
    const std::size_t row = static_cast<std::size_t>(y) * FilmTile::size;
    for (std::size_t i = row; i < row + static_cast<std::size_t>(tile.width); ++i) {
      *to++ = tile.r[i];
      *to++ = tile.g[i];
      *to++ = tile.b[i];
    }
  }
}

void DisplayFilm::put(const FilmTile& tile) {
  const std::size_t row_bytes = 3 * static_cast<std::size_t>(image_.width);
  std::uint8_t* const to = image_.rgb.data() + static_cast<std::size_t>(tile.y) * row_bytes +
                           3 * static_cast<std::size_t>(tile.x);
  develop(rule_, tile, to, row_bytes);
}

void ScanlineFilm::put(const FilmTile& tile) {
  develop(rule_, tile, scanlines_.at(tile.x, tile.y), scanlines_.row_bytes());
  // Acquire and release: the thread that completes the band sees all pixels that others have put.
  std::atomic<int>& come = come_[static_cast<std::size_t>(tile.y)];
  const int before = come.fetch_add(tile.width, std::memory_order_acq_rel);
  if (before + tile.width < scanlines_.width()) return;
  for (int y = tile.y; y < tile.y + tile.height; ++y) scanlines_.filter(y);
}

}  // namespace tia
