#include "tests/core/png/png_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>

#include "tests/core/png/inflate.h"

namespace tia::test {
namespace {

constexpr std::string_view signature = "\x89PNG\r\n\x1A\n";

void require(bool holds, const std::string& otherwise) {
  if (!holds) throw std::runtime_error(otherwise);
}

std::uint32_t number(std::string_view bytes) {
  std::uint32_t value = 0;
  for (const char byte : bytes.substr(0, 4)) value = value << 8U | static_cast<std::uint8_t>(byte);
  return value;
}

// Annex D, with its table.
std::uint32_t crc(std::string_view bytes) {
  static const auto table = [] {
    std::array<std::uint32_t, 256> all{};
    for (std::uint32_t n = 0; n < 256; ++n) {
      std::uint32_t c = n;
      for (int k = 0; k < 8; ++k) c = (c & 1U) != 0 ? 0xEDB88320U ^ (c >> 1U) : c >> 1U;
      all[n] = c;
    }
    return all;
  }();
  std::uint32_t c = 0xFFFFFFFFU;
  for (const char byte : bytes) c = table[(c ^ static_cast<std::uint8_t>(byte)) & 255U] ^ (c >> 8U);
  return c ^ 0xFFFFFFFFU;
}

bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }
bool is_letter(char c) { return is_upper(c) || (c >= 'a' && c <= 'z'); }

// 5.3 and 5.4: length, name, data, sum.
PngChunk take_chunk(std::string_view& rest) {
  require(rest.size() >= 12, "cut short before IEND");
  const std::size_t length = number(rest);
  require(length < 1U << 31U && length <= rest.size() - 12, "a chunk longer than the file");
  PngChunk chunk{std::string(rest.substr(4, 4)), std::string(rest.substr(8, length))};
  require(std::all_of(chunk.type.begin(), chunk.type.end(), is_letter) && is_upper(chunk.type[2]),
          "a chunk's name that may not be");
  require(crc(rest.substr(4, 4 + length)) == number(rest.substr(8 + length)),
          chunk.type + "'s sum is wrong");
  rest.remove_prefix(12 + length);
  return chunk;
}

// 5.6: which there may be, how often, and where. We have no palette.
void check_order(const std::vector<PngChunk>& chunks) {
  const auto is = [&](std::size_t i, std::string_view type) { return chunks[i].type == type; };
  require(is(0, "IHDR") && chunks[0].data.size() == 13, "IHDR does not come first");
  require(chunks.back().data.empty(), "IEND is not empty");
  bool has_pixels = false;
  for (std::size_t i = 1; i + 1 < chunks.size(); ++i) {
    const std::string& type = chunks[i].type;
    static constexpr std::array before = {"cHRM", "gAMA", "iCCP", "sBIT", "sRGB",
                                          "cICP", "bKGD", "pHYs", "eXIf", "tIME"};
    const bool pixels = type == "IDAT";
    require(pixels || !is_upper(type[0]), type + " stands where it may not, or is unknown");
    require(!pixels || !has_pixels || is(i - 1, "IDAT"), "IDATs that do not follow each other");
    if (std::find(before.begin(), before.end(), type) != before.end()) {
      require(!has_pixels || type == "tIME" || type == "eXIf", type + " comes after IDAT");
      for (std::size_t k = 1; k < i; ++k) require(!is(k, type), type + " comes twice");
    }
    has_pixels = has_pixels || pixels;
  }
  require(has_pixels, "no IDAT");
}

std::string take_word(std::string_view& rest) {
  const auto end = rest.find('\0');
  require(end != rest.npos, "a text's part without an end");
  std::string word(rest.substr(0, end));
  rest.remove_prefix(end + 1);
  return word;
}

// RFC 3629: how long a character is by its first byte; 0 = none begins so.
std::size_t utf8_length(std::uint8_t first) {
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first < 0xE0) return 2;
  if (first >= 0xE0 && first < 0xF0) return 3;
  return first >= 0xF0 && first < 0xF5 ? 4 : 0;
}
bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = utf8_length(static_cast<std::uint8_t>(text[0]));
    if (length == 0 || length > text.size()) return false;
    std::uint32_t code = length == 1 ? 0U : static_cast<std::uint8_t>(text[0]) & (0x7FU >> length);
    for (std::size_t i = 1; i < length; ++i) {
      const auto byte = static_cast<std::uint8_t>(text[i]);
      if ((byte & 0xC0U) != 0x80) return false;
      code = code << 6U | (byte & 0x3FU);
    }
    if ((length == 3 && (code < 0x800 || (code >= 0xD800 && code < 0xE000))) ||
        (length == 4 && (code < 0x10000 || code > 0x10FFFF)))
      return false;
    text.remove_prefix(length);
  }
  return true;
}

// 11.3.3.2 and 11.3.3.4.
PngText text_of(const PngChunk& chunk) {
  std::string_view rest = chunk.data;
  const std::string keyword = take_word(rest);
  const auto printed = [](char c) { return c >= ' ' && c <= '~'; };
  require(!keyword.empty() && keyword.size() <= 79 && keyword.front() != ' ' &&
              keyword.back() != ' ' && keyword.find("  ") == keyword.npos &&
              std::all_of(keyword.begin(), keyword.end(), printed),
          "a text's keyword that may not be");
  if (chunk.type == "tEXt") return {keyword, std::string(rest)};
  require(rest.size() >= 2 && (rest[0] == 0 || rest[0] == 1) && rest[1] == 0,
          "a text that is compressed in no known way");
  const bool compressed = rest[0] == 1;
  rest.remove_prefix(2);
  take_word(rest);  // its language
  require(is_utf8(take_word(rest)), "a text's keyword that is no UTF-8");
  std::string text = compressed ? inflated(rest, std::size_t{1} << 30U) : std::string(rest);
  require(is_utf8(text) && text.find('\0') == text.npos, "a text that is no UTF-8");
  return {keyword, std::move(text)};
}

// 9.2 and 9.4: what a byte is counted from, by those to its left, above it, and left above.
int guess(int filter, int a, int b, int c) {
  if (filter < 4) return filter == 0 ? 0 : filter == 1 ? a : filter == 2 ? b : (a + b) / 2;
  const int p = a + b - c, pa = std::abs(p - a), pb = std::abs(p - b), pc = std::abs(p - c);
  return pa <= pb && pa <= pc ? a : pb <= pc ? b : c;
}

// Rows, each with the byte of its filter before it -> rows without.
std::string unfiltered(std::string_view rows, std::size_t width, std::size_t height) {
  constexpr std::size_t pixel = 3;
  const std::size_t row = pixel * width;
  std::string out(row * height, '\0');
  for (std::size_t y = 0; y < height; ++y) {
    const char* const from = rows.data() + y * (row + 1) + 1;
    char* const to = out.data() + y * row;
    const auto byte = [](bool there, const char* at) {
      return there ? static_cast<std::uint8_t>(*at) : 0;
    };
    require(from[-1] >= 0 && from[-1] <= 4, "a row of no known filter");
    for (std::size_t i = 0; i < row; ++i) {
      const bool left = i >= pixel, above = y > 0;
      const int a = byte(left, to + i - pixel), b = byte(above, to + i - row),
                c = byte(left && above, to + i - row - pixel);
      to[i] = static_cast<char>(static_cast<std::uint8_t>(from[i]) + guess(from[-1], a, b, c));
    }
  }
  return out;
}

}  // namespace

Png read_png(std::string_view file) {
  require(file.starts_with(signature), "no PNG");
  Png png;
  std::string_view rest = file.substr(signature.size());
  do png.chunks.push_back(take_chunk(rest));
  while (png.chunks.back().type != "IEND");
  require(rest.empty(), "bytes after IEND");
  check_order(png.chunks);

  const std::string_view header = png.chunks[0].data;
  const std::size_t width = number(header), height = number(header.substr(4));
  require(width > 0 && height > 0 && width < 1U << 26U && height < 1U << 26U, "no such size");
  require(header.substr(8) == std::string_view("\x08\x02\0\0\0", 5), "not 8 bits of RGB");
  std::string stream;
  for (const PngChunk& chunk : png.chunks) {
    if (chunk.type == "IDAT") stream += chunk.data;
    if (chunk.type == "iTXt" || chunk.type == "tEXt") png.texts.push_back(text_of(chunk));
  }
  const std::size_t bytes = (3 * width + 1) * height;
  const std::string rows = inflated(stream, bytes);
  require(rows.size() == bytes, "fewer pixels than its size");
  png.width = static_cast<int>(width);
  png.height = static_cast<int>(height);
  png.rgb = unfiltered(rows, width, height);
  return png;
}

void check_png(std::string_view file) {
  try {
    read_png(file);
  } catch (const std::runtime_error& error) {
    ADD_FAILURE() << "a PNG of " << file.size() << " bytes: " << error.what();
  }
}

}  // namespace tia::test
