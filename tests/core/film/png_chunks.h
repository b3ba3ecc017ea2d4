// The parts of a PNG file, read by no library, and pictures to encode.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "tests/core/support.h"

namespace tia::test {

inline std::uint32_t number_of(std::string_view bytes) {
  std::uint32_t value = 0;
  for (const char c : bytes.substr(0, 4)) value = value << 8U | static_cast<unsigned char>(c);
  return value;
}

// PNG (third edition), annex D: CRC-32, bit by bit.
inline std::uint32_t crc(std::string_view bytes) {
  std::uint32_t c = 0xFFFFFFFFU;
  for (const char byte : bytes) {
    c ^= static_cast<unsigned char>(byte);
    for (int k = 0; k < 8; ++k) c = (c & 1U) != 0 ? 0xEDB88320U ^ (c >> 1U) : c >> 1U;
  }
  return c ^ 0xFFFFFFFFU;
}

struct Chunk {
  std::string type, data;
};

// The chunks after the signature; a test failure where the layout or a checksum is wrong.
inline std::vector<Chunk> chunks_of(const std::string& png) {
  std::vector<Chunk> chunks;
  std::string_view rest = png;
  EXPECT_EQ(rest.substr(0, 8), "\x89PNG\r\n\x1A\n");
  rest.remove_prefix(8);
  while (rest.size() >= 12) {
    const std::size_t length = number_of(rest);
    if (rest.size() < 12 + length) break;
    EXPECT_EQ(number_of(rest.substr(8 + length)), crc(rest.substr(4, 4 + length)));
    chunks.push_back({std::string(rest.substr(4, 4)), std::string(rest.substr(8, length))});
    rest.remove_prefix(12 + length);
  }
  EXPECT_TRUE(rest.empty()) << "bytes after the last chunk";
  return chunks;
}

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
