// Pictures as the tests read them: PNG by stb_image and by libpng, which must agree,
// PFM by the format's own. No decoder is the server's.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace tia::test {

/// Pixels: three numbers a pixel, row 0 on top.
template <class T>
struct Pixels {
  int width = 0, height = 0;
  std::vector<T> rgb;

  T at(int x, int y, int channel) const {
    return rgb[index(x, y) + static_cast<std::size_t>(channel)];
  }
  /// The window x0 <= x < x1, y0 <= y < y1.
  Pixels window(int x0, int y0, int x1, int y1) const;
  bool operator==(const Pixels&) const = default;

 private:
  std::size_t index(int x, int y) const {
    return 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                static_cast<std::size_t>(x));
  }
};
extern template struct Pixels<unsigned char>;
extern template struct Pixels<float>;

Pixels<unsigned char> decode_png(const std::string& file);

Pixels<float> decode_pfm(const std::string& file);

}  // namespace tia::test
