#include "core/film/png_text.h"

#include <libdeflate.h>

#include <algorithm>
#include <memory>
#include <new>

#include "core/film/compressor.h"
#include "core/film/png_chunk.h"
#include "core/input/errors.h"

namespace tia {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view text_type = "iTXt";
constexpr std::size_t header_end = png_signature.size() + 12 + 13;  // IHDR holds 13 bytes

std::string compressed(std::string_view text) {
  const Compressor compressor;
  std::string out(libdeflate_zlib_compress_bound(compressor.get(), text.size()), '\0');
  out.resize(
      libdeflate_zlib_compress(compressor.get(), text.data(), text.size(), out.data(), out.size()));
  return out;
}

// Into a buffer that grows until the text fits or is too long.
std::string decompressed(std::string_view bytes, std::size_t most) {
  struct Free {
    void operator()(libdeflate_decompressor* d) const { libdeflate_free_decompressor(d); }
  };
  const std::unique_ptr<libdeflate_decompressor, Free> decompressor(
      libdeflate_alloc_decompressor());
  if (decompressor == nullptr) throw std::bad_alloc();
  constexpr std::size_t usual = 8;  // times that text is shortened
  for (std::size_t room = usual * (bytes.size() + 1);; room *= 2) {
    std::string text(std::min(room, most), '\0');
    std::size_t size = 0;
    const libdeflate_result result = libdeflate_zlib_decompress(
        decompressor.get(), bytes.data(), bytes.size(), text.data(), text.size(), &size);
    if (result == LIBDEFLATE_SUCCESS) {
      text.resize(size);
      return text;
    }
    if (result != LIBDEFLATE_INSUFFICIENT_SPACE) throw_no_png("a text that cannot be decompressed");
    if (room >= most)
      throw InputError({FaultKind::limit, "", Value("a longer text in the file"),
                        "a text of " + std::to_string(most) + " bytes"});
  }
}

// Takes what stands before the next 0 off the data of a chunk.
std::string_view take_word(std::string_view& data) {
  const auto end = data.find('\0');
  if (end == data.npos) throw_no_png("a text chunk that is cut short");
  const std::string_view word = data.substr(0, end);
  data.remove_prefix(end + 1);
  return word;
}

// What follows the keyword: two bytes of compression, a language, the keyword in it, the text.
std::string text_of(std::string_view data, std::size_t most) {
  if (data.size() < 2 || (data[0] != 0 && data[0] != 1) || data[1] != 0)
    throw_no_png("a text of unknown compression");
  const bool is_compressed = data[0] == 1;
  data.remove_prefix(2);
  take_word(data);
  take_word(data);
  if (is_compressed) return decompressed(data, most);
  if (data.size() > most)
    throw InputError({FaultKind::limit, "", Value("a text of " + std::to_string(data.size())),
                      "a text of " + std::to_string(most) + " bytes"});
  return std::string(data);
}

}  // namespace

std::string with_text(std::string png, std::string_view keyword, std::string_view text) {
  const std::string data = std::string(keyword).append("\0\1\0\0\0"sv).append(compressed(text));
  png.insert(header_end, png_chunk(text_type, data));
  return png;
}

std::string with_plain_text(std::string png, std::string_view keyword, std::string_view text) {
  const std::string data = std::string(keyword).append("\0\0\0\0\0"sv).append(text);
  png.insert(header_end, png_chunk(text_type, data));
  return png;
}

std::optional<std::string> text_in(std::string_view png, std::string_view keyword,
                                   std::size_t most) {
  if (!png.starts_with(png_signature)) throw_no_png("another file");
  std::string_view left = png.substr(png_signature.size());
  std::optional<std::string> text;
  for (bool first = true;; first = false) {
    Chunk chunk = take_chunk(left);
    if ((chunk.type == "IHDR") != first) throw_no_png("a file whose first chunk is no header");
    if (chunk.type == "IEND") break;
    if (chunk.type != text_type || take_word(chunk.data) != keyword) continue;
    if (text) throw_no_png("a file with two such texts");
    text = text_of(chunk.data, most);
  }
  if (!left.empty()) throw_no_png("bytes behind the file's end");
  return text;
}

}  // namespace tia
