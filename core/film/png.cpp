#include "core/film/png.h"

#include <libdeflate.h>

#include <cstdlib>
#include <memory>
#include <new>

#include "core/film/compressor.h"
#include "core/parallel/stopped.h"

namespace {

// What stb's hook has no parameter for.
thread_local const std::stop_token* asked = nullptr;
thread_local libdeflate_compressor* compressor = nullptr;
thread_local unsigned char* stream = nullptr;  // what it gave, which stb forgets where it fails

// stb's hook: a zlib stream in memory that STBIW_FREE can free; null on failure, or told to stop.
unsigned char* deflate(unsigned char* data, int size, int* out_size, int) {
  if (asked->stop_requested()) return nullptr;
  const auto bytes = static_cast<std::size_t>(size);
  const std::size_t bound = libdeflate_zlib_compress_bound(compressor, bytes);
  auto* out = static_cast<unsigned char*>(std::malloc(bound));
  if (out == nullptr) return nullptr;
  const std::size_t written = libdeflate_zlib_compress(compressor, data, bytes, out, bound);
  *out_size = static_cast<int>(written);
  return stream = out;
}

}  // namespace

#define STBIW_ZLIB_COMPRESS deflate
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

namespace tia {
namespace {

// stb's settings are globals: set once, before main.
constexpr int filter_sub = 1;
const int force_filter = stbi_write_force_png_filter = filter_sub;

// Codes of so many channels a pixel.
std::string encode(const std::vector<std::uint8_t>& codes, int width, int height, int channels,
                   const std::stop_token& stop) {
  struct Free {
    void operator()(unsigned char* p) const { std::free(p); }
  };
  static_cast<void>(force_filter);
  end_if_asked(stop);
  const Compressor lent;
  compressor = lent.get();
  asked = &stop;
  stream = nullptr;
  int size = 0;
  const std::unique_ptr<unsigned char, Free> png(
      stbi_write_png_to_mem(codes.data(), channels * width, width, height, channels, &size));
  if (png == nullptr) {
    std::free(stream);
    end_if_asked(stop);
    throw std::bad_alloc();
  }
  return {reinterpret_cast<const char*>(png.get()), static_cast<std::size_t>(size)};
}

}  // namespace

std::string encode_png(const Image8& image, const std::stop_token& stop) {
  return encode(image.rgb, image.width, image.height, 3, stop);
}
std::string encode_png(const ImageRgba8& image, const std::stop_token& stop) {
  return encode(image.rgba, image.width, image.height, 4, stop);
}

std::string png_encoder() { return "libdeflate " LIBDEFLATE_VERSION_STRING; }

}  // namespace tia
