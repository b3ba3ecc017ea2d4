#include "core/film/film.h"

#include <algorithm>
#include <cstring>

namespace tia {
namespace {

void encode_rows(const FilmTile& tile, Encoding encoding, std::uint8_t* to, std::size_t row_bytes) {
  for (int y = 0; y < tile.height; ++y, to += row_bytes) {
    std::array<std::uint8_t, row_codes> codes;
    develop_row(tile, y, encoding, codes);
    std::memcpy(to, codes.data(), 3 * static_cast<std::size_t>(tile.width));
  }
}

// Light over alpha. Where that is 0, so is the light.
FilmTile straight(FilmTile tile) {
  for (int y = 0; y < tile.height; ++y)
    for (int x = 0; x < tile.width; ++x) {
      const std::size_t i = FilmTile::index(x, y);
      const float alpha = tile.alpha[i];
      if (!(alpha > 0)) continue;
      tile.r[i] /= alpha, tile.g[i] /= alpha, tile.b[i] /= alpha;
    }
  return tile;
}

}  // namespace

void Development::operator()(const FilmTile& tile, std::uint8_t* to, std::size_t row_bytes) const {
  const bool is_light = shown_ == FeatureDisplay::light;
  const Encoding encoding = is_light ? tone_.encoding() : Encoding::linear;
  if (is_light && tone_.is_plain()) return encode_rows(tile, encoding, to, row_bytes);
  FilmTile shown = tile;
  if (is_light) develop(tone_, shown);
  else show(shown_, shown);
  encode_rows(shown, encoding, to, row_bytes);
}

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
  develop_(tile, to, row_bytes);
}

AlphaFilm::AlphaFilm(int width, int height, const DisplayRule& rule)
    : image_{width, height, {}}, develop_(rule) {
  image_.rgba.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
}

void AlphaFilm::put(const FilmTile& tile) {
  std::array<std::uint8_t, std::size_t{FilmTile::size} * row_codes> codes;
  develop_(straight(tile), codes.data(), row_codes);
  for (int y = 0; y < tile.height; ++y) {
    const std::uint8_t* from = codes.data() + static_cast<std::size_t>(y) * row_codes;
    const std::size_t row = static_cast<std::size_t>(tile.y + y);
    std::uint8_t* to = image_.rgba.data() + 4 * (row * static_cast<std::size_t>(image_.width) +
                                                 static_cast<std::size_t>(tile.x));
    for (int x = 0; x < tile.width; ++x, from += 3) {
      to = std::copy_n(from, 3, to);
      *to++ = static_cast<std::uint8_t>(tile.alpha[FilmTile::index(x, y)] * 255 + 0.5F);
    }
  }
}

void ScanlineFilm::put(const FilmTile& tile) {
  develop_(tile, scanlines_.at(tile.x, tile.y), scanlines_.row_bytes());
  // Acquire and release: the thread that completes the band sees all pixels that others have put.
  std::atomic<int>& come = come_[static_cast<std::size_t>(tile.y)];
  const int before = come.fetch_add(tile.width, std::memory_order_acq_rel);
  if (before + tile.width < scanlines_.width()) return;
  for (int y = tile.y; y < tile.y + tile.height; ++y) scanlines_.filter(y);
}

}  // namespace tia
