// Lossless WebP files put together bit by bit, for tests of what reads them.
#pragma once

#include <string>
#include <string_view>

#include "tests/core/film/files.h"

namespace tia::test {

/// A RIFF chunk: its name, its length, its bytes, and one more where these are odd.
inline std::string riff_chunk(const std::string& name, std::string data) {
  std::string out = name;
  for (int shift = 0; shift < 32; shift += 8) out += static_cast<char>(data.size() >> shift & 255U);
  if (data.size() % 2 != 0) data += '\0';
  return out + data;
}

inline Bytes webp_file(const std::string& chunks) {
  return to_bytes(riff_chunk("RIFF", "WEBP" + chunks));
}

/// Bits, the lowest of each number first, into bytes from their lowest bit on.
class LowBits {
 public:
  void put(unsigned value, int count) {
    for (int i = 0; i < count; ++i) bits_ += (value >> i & 1U) != 0 ? '1' : '0';
  }
  std::string bytes() const {
    std::string out((bits_.size() + 7) / 8, '\0');
    for (std::size_t i = 0; i < bits_.size(); ++i)
      if (bits_[i] == '1') out[i / 8] = static_cast<char>(out[i / 8] | 1 << i % 8);
    return out;
  }

 private:
  std::string bits_;
};

/// What a picture of two greens has everywhere, and its two greens, the smaller first.
struct WebpColors {
  unsigned red, green, other_green, blue, alpha;
};

/// A lossless WebP: of each pixel '1' in `pixels` has the other green, row by row.
/// A code of one symbol takes no bits; of two, the smaller has the bit 0.
/// Source: RFC 9649, 3.4 (header), 3.7.2.1.1 (simple codes).
inline std::string lossless_stream(unsigned width, unsigned height, const WebpColors& colors,
                                   std::string_view pixels) {
  LowBits bits;
  bits.put(0x2F, 8);
  bits.put(width - 1, 14);
  bits.put(height - 1, 14);
  bits.put(1, 1);  // alpha is used
  bits.put(0, 3);  // version
  bits.put(0, 3);  // no transform, no cache of colours, one set of codes
  bits.put(7, 3);  // green: a simple code of two symbols, the first of 8 bits
  bits.put(colors.green, 8);
  bits.put(colors.other_green, 8);
  for (const unsigned symbol : {colors.red, colors.blue, colors.alpha}) {
    bits.put(5, 3);  // of one
    bits.put(symbol, 8);
  }
  bits.put(1, 3);  // distances: of one, which has one bit
  bits.put(0, 1);
  for (const char pixel : pixels) bits.put(pixel == '1' ? 1 : 0, 1);
  return bits.bytes();
}

inline Bytes lossless_webp(unsigned width, unsigned height, const WebpColors& colors,
                           std::string_view pixels) {
  return webp_file(riff_chunk("VP8L", lossless_stream(width, height, colors, pixels)));
}

}  // namespace tia::test
