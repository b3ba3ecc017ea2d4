// What is denoised of a picture: traced with a margin, filtered as a whole, handed on in tiles.
#pragma once

#include <functional>
#include <vector>

#include "core/film/denoise.h"
#include "core/film/image.h"
#include "core/render/halves.h"
#include "core/render/window.h"

namespace tia {

/// DenoisedWindow: of a picture of that size. Its bytes are those of the whole picture's part.
class DenoisedWindow {
 public:
  DenoisedWindow(const Window& window, int picture_width, int picture_height);

  const Window& traced() const { return traced_; }
  const HalfBuffers& halves() const { return halves_; }
  /// Takes a tile's pixels. Any thread may put tiles of what is traced.
  void put(const FilmTile& place, const std::vector<Halves>& pixels);
  /// Keeps alpha, of which no noise is taken off. The same.
  void put_alpha(const FilmTile& tile);
  /// Hands tiles of the window with the light that has been made of what is traced to `develop`,
  /// from several threads at once.
  void develop(const Image& light, const Workers& workers,
               const std::function<void(FilmTile&)>& develop) const;

 private:
  Window window_, traced_;
  HalfBuffers halves_;
  std::vector<float> alpha_;
};

}  // namespace tia
