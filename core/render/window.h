// Which part of a picture is drawn.
#pragma once

#include <algorithm>

namespace tia {

/// Window: the pixels x0 <= x < x1, y0 <= y < y1 of a picture.
struct Window {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  int width() const { return x1 - x0; }
  int height() const { return y1 - y0; }
  /// With so many more pixels on every side, as far as the picture goes.
  Window grown(int by, int picture_width, int picture_height) const {
    return {std::max(x0 - by, 0), std::max(y0 - by, 0), std::min(x1 + by, picture_width),
            std::min(y1 + by, picture_height)};
  }
  bool operator==(const Window&) const = default;
};

/// Whether they have a pixel in common.
inline bool overlap(const Window& a, const Window& b) {
  return std::max(a.x0, b.x0) < std::min(a.x1, b.x1) && std::max(a.y0, b.y0) < std::min(a.y1, b.y1);
}

}  // namespace tia
