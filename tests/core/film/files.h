// PNG and JPEG files put together from their parts, for tests of what reads them.
#pragma once

#include <libdeflate.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "tests/core/support.h"

namespace tia::test {

using Bytes = std::vector<std::uint8_t>;

inline Bytes to_bytes(std::string_view text) { return {text.begin(), text.end()}; }

inline std::string to_text(const Bytes& bytes) { return {bytes.begin(), bytes.end()}; }

inline std::string base64(std::string_view bytes) {
  constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = i; k < i + 3; ++k)
      bits = bits << 8U | (k < bytes.size() ? static_cast<std::uint8_t>(bytes[k]) : 0U);
    for (int k = 3; k >= 0; --k) text += digits[bits >> (6 * k) & 63U];
  }
  for (std::size_t k = 0; k < (3 - bytes.size() % 3) % 3; ++k) text[text.size() - 1 - k] = '=';
  return text;
}

// ---- PNG ------------------------------------------------------------------------------------

constexpr char grey = 0, rgb = 2, palette = 3, grey_alpha = 4, rgba = 6;

struct PngHeader {
  std::uint32_t width, height;
  char depth, color;
};

inline std::string big_endian(std::uint32_t number) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(number >> shift & 255U);
  return bytes;
}

inline std::string png_chunk(const std::string& name, const std::string& data) {
  const std::string named = name + data;
  return big_endian(static_cast<std::uint32_t>(data.size())) + named +
         big_endian(libdeflate_crc32(0, named.data(), named.size()));
}

/// A file of that header, palette (none where it is empty) and zlib stream.
inline std::string png_file(const PngHeader& header, const std::string& stream,
                            const std::string& colors) {
  std::string fields = big_endian(header.width) + big_endian(header.height);
  fields += header.depth;
  fields += header.color;
  fields.append(3, '\0');
  return "\x89PNG\r\n\x1A\n" + png_chunk("IHDR", fields) +
         (colors.empty() ? "" : png_chunk("PLTE", colors)) + png_chunk("IDAT", stream) +
         png_chunk("IEND", "");
}

inline std::string zlib(const std::string& data) {
  const std::unique_ptr<libdeflate_compressor, void (*)(libdeflate_compressor*)> compressor(
      libdeflate_alloc_compressor(9), libdeflate_free_compressor);
  std::string out(libdeflate_zlib_compress_bound(compressor.get(), data.size()), '\0');
  out.resize(
      libdeflate_zlib_compress(compressor.get(), data.data(), data.size(), out.data(), out.size()));
  return out;
}

/// A zlib stream of so many runs of 258 zeros, 13 bits each. Source: RFC 1951, 3.2.5 and 3.2.6.
inline std::string zlib_of_zeros(int runs) {
  std::string bits = "110";                                // the last block, of the fixed codes
  bits += "00110000";                                      // a zero
  for (int i = 0; i < runs; ++i) bits += "1100010100000";  // the last 258 bytes, 1 byte back
  bits += "0000000";                                       // the end
  std::string out = "\x78\x01";
  for (std::size_t i = 0; i < bits.size(); i += 8) {
    int byte = 0;
    for (std::size_t k = i; k < std::min(i + 8, bits.size()); ++k)
      byte |= (bits[k] - '0') << (k - i);
    out += static_cast<char>(byte);
  }
  return out + "sum.";  // which the decoder does not look at
}

/// The rows' bytes, unfiltered and packed, as a file.
inline Bytes png(const PngHeader& header, const std::string& rows, const std::string& colors = "") {
  const std::size_t row = rows.size() / header.height;
  std::string filtered;
  for (std::size_t y = 0; y < header.height && row > 0; ++y)
    filtered += '\0' + rows.substr(y * row, row);
  return to_bytes(png_file(header, zlib(filtered), colors));
}

/// A PNG file with a chunk before its pixels.
inline Bytes with_chunk_before_pixels(const Bytes& file, const std::string& chunk) {
  const Bytes name = to_bytes("IDAT");
  const auto pixels = std::search(file.begin(), file.end(), name.begin(), name.end()) - 4;
  Bytes more(file.begin(), pixels);
  more.insert(more.end(), chunk.begin(), chunk.end());
  more.insert(more.end(), pixels, file.end());
  return more;
}

// ---- JPEG -----------------------------------------------------------------------------------

/// Bits of entropy-coded data: the first is the highest of its byte, the last byte ends in ones,
/// after 0xFF comes 0.
class BitWriter {
 public:
  void put(int value, int count) {
    for (int i = count - 1; i >= 0; --i) bits_ += (value >> i & 1) != 0 ? '1' : '0';
  }
  Bytes bytes() const {
    Bytes out;
    for (std::size_t i = 0; i < bits_.size(); i += 8) {
      std::string byte = bits_.substr(i, 8);
      byte.resize(8, '1');
      out.push_back(static_cast<std::uint8_t>(std::stoi(byte, nullptr, 2)));
      if (out.back() == 0xFF) out.push_back(0);
    }
    return out;
  }

 private:
  std::string bits_;
};

/// The bits of a number's size class, at most 8, and the number. Source: ITU-T T.81, F.1.2.1.
inline void put_difference(int difference, BitWriter& scan) {
  int size = 0;
  while (std::abs(difference) >> size != 0) ++size;
  scan.put(size, 4);
  scan.put(difference >= 0 ? difference : difference + (1 << size) - 1, size);
}

enum class JpegKind : std::uint8_t { baseline = 0xC0, progressive = 0xC2 };

/// A JPEG of 8 x 8 pixels whose every component (one, or Y, Cb and Cr) is flat. Each block
/// is the difference of its mean to 128, whose size class s has the code s of 4 bits, and the code
/// 0 of 1 bit for the end of the block. A progressive one has the ends in scans of their own.
/// Source: ITU-T T.81, B.2.
inline Bytes flat_jpeg(const std::vector<int>& means, JpegKind kind = JpegKind::baseline) {
  const auto count = static_cast<std::uint8_t>(means.size());
  const auto three = static_cast<std::uint8_t>(3 * count);
  Bytes file{0xFF, 0xD8, 0xFF, 0xDB, 0, 67, 0};
  file.insert(file.end(), 64, 8);  // quantised by 8
  const auto add = [&](const Bytes& more) { file.insert(file.end(), more.begin(), more.end()); };
  add({0xFF, static_cast<std::uint8_t>(kind), 0, static_cast<std::uint8_t>(8 + three), 8, 0, 8, 0,
       8, count});
  for (std::uint8_t i = 1; i <= count; ++i) add({i, 0x11, 0});
  add({0xFF, 0xC4, 0, 28, 0x00, 0, 0, 0, 9, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  add({0, 1, 2, 3, 4, 5, 6, 7, 8});
  add({0xFF, 0xC4, 0, 20, 0x10, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  const bool baseline = kind == JpegKind::baseline;
  add({0xFF, 0xDA, 0, static_cast<std::uint8_t>(6 + three - count), count});
  for (std::uint8_t i = 1; i <= count; ++i) add({i, 0});
  add({0, static_cast<std::uint8_t>(baseline ? 63 : 0), 0});
  BitWriter scan;
  for (const int mean : means) {
    put_difference(mean - 128, scan);
    if (baseline) scan.put(0, 1);
  }
  add(scan.bytes());
  for (std::uint8_t i = 1; i <= count && !baseline; ++i)
    add({0xFF, 0xDA, 0, 8, 1, i, 0, 1, 63, 0, 0x7F});
  add({0xFF, 0xD9});
  return file;
}

}  // namespace tia::test
