#include "core/render/denoised_window.h"

namespace tia {

DenoisedWindow::DenoisedWindow(const Window& window, int picture_width, int picture_height)
    : window_(window),
      traced_(window.grown(denoise_margin, picture_width, picture_height)),
      halves_{PixelPlanes(traced_.width(), traced_.height()),
              PixelPlanes(traced_.width(), traced_.height()), traced_.x0, traced_.y0},
      alpha_(halves_.a.size()) {}

void DenoisedWindow::put_alpha(const FilmTile& tile) {
  for (int y = 0; y < tile.height; ++y)
    std::copy_n(&tile.alpha[FilmTile::index(0, y)], tile.width,
                &alpha_[static_cast<std::size_t>((tile.y + y) * traced_.width() + tile.x)]);
}

void DenoisedWindow::put(const FilmTile& place, const std::vector<Halves>& pixels) {
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const int number = static_cast<int>(i);
    const int x = place.x + number % place.width, y = place.y + number / place.width;
    const std::size_t at = static_cast<std::size_t>(y * traced_.width() + x);
    for (std::size_t plane = 0; plane < PixelPlanes::count; ++plane) {
      halves_.a.planes[plane][at] = pixels[i].a[plane];
      halves_.b.planes[plane][at] = pixels[i].b[plane];
    }
  }
}

void DenoisedWindow::develop(const Image& image, const Workers& workers,
                             const std::function<void(FilmTile&)>& develop) const {
  const int columns = (window_.width() + FilmTile::size - 1) / FilmTile::size;
  const int rows = (window_.height() + FilmTile::size - 1) / FilmTile::size;
  workers.for_each(columns * rows, [&](int i) {
    FilmTile tile;
    tile.x = i % columns * FilmTile::size, tile.y = i / columns * FilmTile::size;
    tile.width = std::min(FilmTile::size, window_.width() - tile.x);
    tile.height = std::min(FilmTile::size, window_.height() - tile.y);
    for (int y = 0; y < tile.height; ++y)
      for (int x = 0; x < tile.width; ++x) {
        const int from_x = window_.x0 - traced_.x0 + tile.x + x;
        const int from_y = window_.y0 - traced_.y0 + tile.y + y;
        const float* light = image.at(from_x, from_y);
        const std::size_t at = FilmTile::index(x, y);
        tile.r[at] = light[0], tile.g[at] = light[1], tile.b[at] = light[2];
        tile.alpha[at] = alpha_[static_cast<std::size_t>(from_y * traced_.width() + from_x)];
      }
    develop(tile);
  });
}

}  // namespace tia
