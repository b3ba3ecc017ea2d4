// What is denoised of a picture: traced with a margin, filtered as a whole, handed on in tiles.
#pragma once

#include <functional>
#include <vector>

#include "core/film/denoise.h"
#include "core/film/image.h"
#include "core/render/window.h"

namespace tia {

/// DenoisedWindow: of a picture of that size. Its bytes are those of the whole picture's part.
class DenoisedWindow {
 public:
  DenoisedWindow(const Window& window, int picture_width, int picture_height);

  const Window& traced() const { return traced_; }
  HalfBuffers& halves() { return halves_; }
  /// Keeps alpha, of which no noise is taken off. Any thread may put tiles of what is traced.
  void put_alpha(const FilmTile& tile);
  /// Hands finished tiles of the window to `develop`, from several threads at once.
  void develop(const Workers& workers, const std::function<void(FilmTile&)>& develop) const;

 private:
  Window window_, traced_;
  HalfBuffers halves_;
  std::vector<float> alpha_;
};

}  // namespace tia
