#include "tests/core/png/png_reader.h"

#include <gtest/gtest.h>
#include <png.h>

#include <csetjmp>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <regex>
#include <stdexcept>

namespace tia::test {
namespace {

void require(bool holds, const char* otherwise) {
  if (!holds) throw std::runtime_error(otherwise);
}

/// Reader: libpng over bytes in memory; what it would only warn of is an error too.
class Reader {
 public:
  explicit Reader(std::string_view file)
      : rest_(file),
        png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, &fault_, fail, fail)),
        info_(png_create_info_struct(png_)) {
    png_set_read_fn(png_, &rest_, take);
    png_set_benign_errors(png_, 0);
    png_set_crc_action(png_, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
    png_set_user_limits(png_, 1U << 26U, 1U << 26U);
    png_set_chunk_malloc_max(png_, std::size_t{1} << 30U);
  }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;
  ~Reader() { png_destroy_read_struct(&png_, &info_, nullptr); }

  // What stands before the pixels. Errors: anything wrong up to there.
  void read_head() {
    guarded([this] { png_read_info(png_, info_); });
  }
  std::uint32_t width() const { return png_get_image_width(png_, info_); }
  std::uint32_t height() const { return png_get_image_height(png_, info_); }
  bool has_alpha() const { return png_get_color_type(png_, info_) == PNG_COLOR_TYPE_RGB_ALPHA; }
  bool is_rgb8() const {
    return png_get_bit_depth(png_, info_) == 8 &&
           (has_alpha() || png_get_color_type(png_, info_) == PNG_COLOR_TYPE_RGB) &&
           png_get_interlace_type(png_, info_) == PNG_INTERLACE_NONE;
  }

  // Three bytes a pixel, four with alpha. Domain: is_rgb8().
  // Errors: anything wrong in the rest of the file.
  std::string pixels() {
    const std::size_t row = std::size_t{png_get_channels(png_, info_)} * width();
    std::string pixels(row * height(), '\0');
    guarded([&] {
      for (std::size_t y = 0; y < height(); ++y)
        png_read_row(png_, reinterpret_cast<png_bytep>(pixels.data() + y * row), nullptr);
      png_read_end(png_, info_);
    });
    require(rest_.empty(), "bytes after IEND");
    return pixels;
  }

  std::vector<PngText> texts() const {
    png_textp all = nullptr;
    const int count = png_get_text(png_, info_, &all, nullptr);
    std::vector<PngText> texts;
    for (int i = 0; i < count; ++i) {
      const bool is_international = all[i].compression >= PNG_ITXT_COMPRESSION_NONE;
      const std::size_t size = is_international ? all[i].itxt_length : all[i].text_length;
      texts.push_back({all[i].key, std::string(all[i].text, size)});
      if (is_international) check_unicode(texts.back().text + all[i].lang_key);
      check_keyword(texts.back().keyword);
    }
    return texts;
  }

 private:
  // What libpng leaves to who uses it. 11.3.3.2: printed characters, one space at a time.
  static void check_keyword(const std::string& keyword) {
    static const std::regex words("[!-~]+( [!-~]+)*");
    require(keyword.size() <= 79 && std::regex_match(keyword, words),
            "a text's keyword that may not be");
  }
  static void check_unicode(const std::string& text) {
    require(text.find('\0') == text.npos, "a text with an end inside");
    try {
      static_cast<void>(nlohmann::json(text).dump());
    } catch (const nlohmann::json::type_error&) {
      throw std::runtime_error("a text that is no UTF-8");
    }
  }

  // libpng is C: its errors jump here. Domain: a call that leaves nothing to be destroyed.
  template <class Call>
  void guarded(const Call& call) {
    if (setjmp(png_jmpbuf(png_)) != 0) throw std::runtime_error(fault_);
    call();
  }
  [[noreturn]] static void fail(png_structp png, png_const_charp why) {
    *static_cast<std::string*>(png_get_error_ptr(png)) = why;
    png_longjmp(png, 1);
  }
  static void take(png_structp png, png_bytep to, std::size_t bytes) {
    auto& rest = *static_cast<std::string_view*>(png_get_io_ptr(png));
    if (rest.copy(reinterpret_cast<char*>(to), bytes) < bytes) png_error(png, "cut short");
    rest.remove_prefix(bytes);
  }

  std::string fault_;
  std::string_view rest_;
  png_structp png_;
  png_infop info_;
};

// 5.3: length, name, data, sum. Domain: a file that libpng has read.
std::vector<PngChunk> chunks_in(std::string_view file) {
  std::vector<PngChunk> chunks;
  for (file.remove_prefix(8); !file.empty();) {
    const std::size_t length = png_get_uint_32(reinterpret_cast<png_const_bytep>(file.data()));
    chunks.push_back({std::string(file.substr(4, 4)), std::string(file.substr(8, length))});
    require((chunks.back().type[2] & 0x20) == 0, "a chunk's name that is reserved");
    file.remove_prefix(12 + length);
  }
  return chunks;
}

}  // namespace

Png read_png(std::string_view file) {
  Reader reader(file);
  reader.read_head();
  require(reader.is_rgb8(), "not 8 bits of RGB or RGBA");
  Png png{static_cast<int>(reader.width()), static_cast<int>(reader.height()), {}, {}, {}, {}};
  std::string& pixels = reader.has_alpha() ? png.rgba : png.rgb;
  pixels = reader.pixels();
  png.texts = reader.texts();
  png.chunks = chunks_in(file);
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
