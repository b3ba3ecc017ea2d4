#include "core/film/decode.h"

#include <cstdlib>
#include <cstring>
#include <memory>
#include <string_view>
#include <vector>

namespace {

// The largest piece of memory that the decoder gets on this thread. A header's pixels set it, so
// that a zlib stream which unpacks to more than these ends in an error.
thread_local std::size_t most_at_once = 0;

// Zeroed: where a file lacks a component stb_image shows what it finds in memory.
void* allocate(std::size_t size) { return size <= most_at_once ? std::calloc(1, size) : nullptr; }
void* reallocate(void* p, std::size_t size) {
  return size <= most_at_once ? std::realloc(p, size) : nullptr;
}

}  // namespace

#define STBI_MALLOC(size) allocate(size)
#define STBI_REALLOC(p, size) reallocate(p, size)
#define STBI_FREE(p) std::free(p)
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_HDR
#define STBI_NO_LINEAR
#define STBI_NO_STDIO
#define STBI_NO_SIMD  // whose cosine transform rounds otherwise than the plain one
#define STBI_NO_FAILURE_STRINGS
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#include <stb/stb_image.h>

namespace tia {
namespace {

using File = std::span<const std::uint8_t>;
using Bytes = std::vector<std::uint8_t>;

const PictureFault broken{false, "bytes that cannot be decoded", "a whole PNG or JPEG picture"};

std::size_t big_endian(File bytes) {
  return std::size_t{bytes[0]} << 24U | std::size_t{bytes[1]} << 16U | std::size_t{bytes[2]} << 8U |
         bytes[3];
}

bool starts_with(File file, std::string_view text) {
  return file.size() >= text.size() && std::memcmp(file.data(), text.data(), text.size()) == 0;
}
bool is_png(File file) { return starts_with(file, "\x89PNG\r\n\x1A\n"); }
bool is_jpeg(File file) { return starts_with(file, "\xFF\xD8\xFF"); }

// Within a scan's codes 0xFF is followed by 0, so each of these begins a scan or stands in a
// comment. Source: ITU-T T.81, B.1.1.5.
int scans_of(File jpeg) {
  int scans = 0;
  for (std::size_t i = 1; i < jpeg.size(); ++i)
    scans += jpeg[i - 1] == 0xFF && jpeg[i] == 0xDA ? 1 : 0;
  return scans;
}

// A PNG whose palette names all 256 colours, those that were missing black: stb_image reads beyond
// a shorter one. A chunk is its length, its name, its bytes, a checksum.
Bytes with_whole_palette(File png) {
  constexpr std::size_t whole = 3 * 256, around = 12;
  Bytes out(png.begin(), png.end());
  for (std::size_t at = 8; png.size() - at >= around;) {
    const std::size_t length = big_endian(png.subspan(at));
    if (length > png.size() - at - around) break;
    if (starts_with(png.subspan(at + 4), "PLTE")) {
      if (length >= whole || length % 3 != 0) break;
      out.insert(out.begin() + static_cast<std::ptrdiff_t>(at + 8 + length), whole - length, 0);
      out[at + 2] = whole >> 8U;
      out[at + 3] = whole & 0xFFU;
      break;
    }
    at += around + length;
  }
  return out;
}

// PNG: 16 bits of four channels, and twice that while a buffer grows. JPEG: blocks of 32 x 32, two
// bytes a coefficient. Either: the file's bytes, and tables.
std::size_t memory_for(const PictureSize& size, std::size_t file_bytes) {
  const auto side = [](int pixels) { return static_cast<std::size_t>(pixels) + 32; };
  return 16 * side(size.width) * side(size.height) + 2 * file_bytes + (1U << 16U);
}

struct Free {
  void operator()(stbi_uc* p) const { std::free(p); }
};

}  // namespace

std::variant<PictureSize, PictureFault> measure_picture(File file) {
  if (file.size() > most_picture_bytes)
    return PictureFault{true, std::to_string(file.size()) + " bytes",
                        "a picture of at most " + std::to_string(most_picture_bytes) + " bytes"};
  if (!is_png(file) && !is_jpeg(file))
    return PictureFault{false, "bytes that begin like neither", "a whole PNG or JPEG picture"};
  PictureSize size;
  int channels = 0;
  most_at_once = memory_for({}, file.size());
  if (stbi_info_from_memory(file.data(), static_cast<int>(file.size()), &size.width, &size.height,
                            &channels) == 0 ||
      size.width < 1 || size.height < 1)
    return broken;
  if (size.pixels() > most_picture_pixels)
    return PictureFault{
        true, std::to_string(size.width) + " x " + std::to_string(size.height) + " pixels",
        "a picture of at most " + std::to_string(most_picture_pixels) + " pixels"};
  if (is_jpeg(file) && scans_of(file) > most_picture_scans)
    return PictureFault{true, std::to_string(scans_of(file)) + " scans",
                        "a picture of at most " + std::to_string(most_picture_scans) + " scans"};
  return size;
}

std::variant<Image8, PictureFault> decode_picture(File file) {
  const auto measured = measure_picture(file);
  if (const auto* fault = std::get_if<PictureFault>(&measured)) return *fault;
  const auto size = std::get<PictureSize>(measured);
  const Bytes whole = is_png(file) ? with_whole_palette(file) : Bytes(file.begin(), file.end());
  most_at_once = memory_for(size, whole.size());
  Image8 image(size.width, size.height);
  int width = 0, height = 0, channels = 0;
  const std::unique_ptr<stbi_uc, Free> codes(stbi_load_from_memory(
      whole.data(), static_cast<int>(whole.size()), &width, &height, &channels, 3));
  if (codes == nullptr || width != size.width || height != size.height) return broken;
  std::memcpy(image.rgb.data(), codes.get(), image.rgb.size());
  return image;
}

}  // namespace tia
