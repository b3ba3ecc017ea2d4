#include "tests/server/picture_support.h"

#include <algorithm>
#include <cstring>
#include <memory>
#include <sstream>
#include <stdexcept>

#include "tests/core/png/png_reader.h"

#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#include <stb/stb_image.h>

namespace tia::test {

template <class T>
Pixels<T> Pixels<T>::window(int x0, int y0, int x1, int y1) const {
  Pixels out{x1 - x0, y1 - y0, {}};
  for (int y = y0; y < y1; ++y)
    out.rgb.insert(out.rgb.end(), rgb.begin() + static_cast<std::ptrdiff_t>(index(x0, y)),
                   rgb.begin() + static_cast<std::ptrdiff_t>(index(x1, y)));
  return out;
}
template struct Pixels<unsigned char>;
template struct Pixels<float>;

Pixels<unsigned char> decode_png(const std::string& file) {
  const Png read = read_png(file);
  Pixels<unsigned char> image;
  int channels = 0;
  const std::unique_ptr<unsigned char, void (*)(void*)> data(
      stbi_load_from_memory(reinterpret_cast<const unsigned char*>(file.data()),
                            static_cast<int>(file.size()), &image.width, &image.height, &channels,
                            0),
      stbi_image_free);
  if (data == nullptr || channels != 3) throw std::runtime_error("not a PNG of three channels");
  const auto pixels =
      static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  image.rgb.assign(data.get(), data.get() + 3 * pixels);
  if (!std::equal(read.rgb.begin(), read.rgb.end(), image.rgb.begin(), image.rgb.end(),
                  [](char a, unsigned char b) { return static_cast<unsigned char>(a) == b; }))
    throw std::runtime_error("a PNG that two readers read otherwise");
  return image;
}

Pixels<float> decode_pfm(const std::string& file) {
  std::istringstream head(file);
  std::string magic, scale;
  Pixels<float> image;
  head >> magic >> image.width >> image.height >> scale;
  if (magic != "PF" || scale != "-1.0" || head.get() != '\n')
    throw std::runtime_error("not a little-endian PFM of three channels");
  const std::size_t row = 3 * static_cast<std::size_t>(image.width);
  const auto rows = static_cast<std::size_t>(image.height);
  const auto start = static_cast<std::size_t>(head.tellg());
  image.rgb.resize(row * rows);
  if (file.size() - start != image.rgb.size() * sizeof(float))
    throw std::runtime_error("a PFM of the wrong length");
  for (std::size_t y = 0; y < rows; ++y)
    std::memcpy(&image.rgb[(rows - 1 - y) * row], &file[start + y * row * sizeof(float)],
                row * sizeof(float));
  return image;
}

}  // namespace tia::test
