// The parts of a PNG file, and pictures to encode.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "tests/core/png/png_reader.h"
#include "tests/core/support.h"

namespace tia::test {

inline std::uint32_t number_of(std::string_view bytes) {
  std::uint32_t value = 0;
  for (const char c : bytes.substr(0, 4)) value = value << 8U | static_cast<unsigned char>(c);
  return value;
}

using Chunk = PngChunk;

// The chunks after the signature. Errors: std::runtime_error where anything of the file is wrong.
inline std::vector<Chunk> chunks_of(const std::string& png) { return read_png(png).chunks; }

inline Image8 noise(int width, int height, std::uint64_t seed) {
  Random random(seed);
  Image8 image(width, height);
  for (auto& code : image.rgb) code = static_cast<std::uint8_t>(random.below(256));
  return image;
}
inline Image8 ramp(int width, int height) {
  Image8 image(width, height);
  for (std::size_t i = 0; i < image.rgb.size(); ++i)
    image.rgb[i] = static_cast<std::uint8_t>(i / 3 + i % 3 * 40);
  return image;
}

/// A picture's filtered rows.
inline Scanlines scanlines_of(const Image8& image) {
  Scanlines lines(image.width, image.height);
  const std::size_t row_bytes = lines.row_bytes() - 1;
  for (int y = 0; y < image.height; ++y) {
    std::memcpy(lines.at(0, y), image.rgb.data() + static_cast<std::size_t>(y) * row_bytes,
                row_bytes);
    lines.filter(y);
  }
  return lines;
}

}  // namespace tia::test
