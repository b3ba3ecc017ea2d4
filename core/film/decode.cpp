#include "core/film/decode.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <string_view>
#include <utility>
#include <vector>

namespace {

// The largest piece of memory that the decoder gets on this thread. A header's pixels set it, so
// that a zlib stream which unpacks to more than these ends in an error.
thread_local std::size_t most_at_once = 0;
// Whether it did not get a smaller one: then nothing is wrong with the file.
thread_local bool is_short = false;

void* noted(void* p) {
  if (p == nullptr) is_short = true;
  return p;
}
// Zeroed: where a file lacks a component stb_image shows what it finds in memory.
void* allocate(std::size_t size) {
  return size <= most_at_once ? noted(std::calloc(1, size)) : nullptr;
}
void* reallocate(void* p, std::size_t size) {
  return size <= most_at_once ? noted(std::realloc(p, size)) : nullptr;
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

// Errors: std::bad_alloc where that is why they were not decoded.
PictureFault broken() {
  if (std::exchange(is_short, false)) throw std::bad_alloc();
  return {false, "bytes that cannot be decoded", "a whole PNG or JPEG picture"};
}

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

// Whether a JPEG's first frame is a progressive one, as stb_image looks for it: through the
// segments, and past what stands between them. Source: ITU-T T.81, B.1.1.4 and B.2.2.
bool is_progressive(File jpeg) {
  for (std::size_t at = 2; at + 3 < jpeg.size();) {
    if (jpeg[at] != 0xFF || jpeg[at + 1] == 0xFF) {
      ++at;
      continue;
    }
    const int marker = jpeg[at + 1];
    if (marker >= 0xC0 && marker <= 0xC2) return marker == 0xC2;
    at += 2 + (std::size_t{jpeg[at + 2]} << 8U | jpeg[at + 3]);
  }
  return false;
}

// Whether one of the Huffman tables of a segment, of which `at` is the length, has more codes than
// there are bytes: stb_image writes them all. A segment is its length and its tables, a table its
// class and number, how many codes there are of each of 16 lengths, and their values.
// Source: ITU-T T.81, B.2.4.2.
// `tables` counts those that it has looked at.
bool has_too_many_codes(File jpeg, std::size_t at, int& tables) {
  const auto byte = [&](std::size_t i) { return i < jpeg.size() ? int{jpeg[i]} : 0; };
  int length = 256 * byte(at) + byte(at + 1) - 2;
  for (at += 2; length > 0; ++tables) {
    int codes = 0;
    for (std::size_t i = 1; i <= 16; ++i) codes += byte(at + i);
    if (codes > 256) return byte(at) >> 4 <= 1 && (byte(at) & 15) <= 3;
    length -= 17 + codes;
    at += 17 + static_cast<std::size_t>(codes);
  }
  return false;
}
// Wherever such a segment may begin, for stb_image does not say where it found one. Of those that
// overlap a file could hold a million tables: one with more than any picture has counts as broken.
bool has_broken_tables(File jpeg) {
  constexpr int most_tables = 1 << 16;
  int tables = 0;
  for (std::size_t i = 1; i < jpeg.size() && tables <= most_tables; ++i)
    if (jpeg[i - 1] == 0xFF && jpeg[i] == 0xC4 && has_too_many_codes(jpeg, i + 1, tables))
      return true;
  return tables > most_tables;
}

// A PNG's chunks as stb_image can take them: a palette names all 256 colours, those that were
// missing black, for it reads beyond a shorter one; and no pixels' chunk is empty, for it copies
// that to nowhere. What follows the end, or the last whole chunk, is dropped. A chunk is its
// length, its name, its bytes, a checksum. Source: W3C PNG (third edition), 5.3.
Bytes mended(File png) {
  constexpr std::size_t signature = 8, around = 12, whole = 3 * 256;
  Bytes out(png.begin(), png.begin() + signature);
  for (std::size_t at = signature; png.size() - at >= around;) {
    const std::size_t length = big_endian(png.subspan(at));
    if (length > png.size() - at - around) break;
    const File chunk = png.subspan(at, around + length), name = chunk.subspan(4);
    at += chunk.size();
    if (length == 0 && starts_with(name, "IDAT")) continue;
    const std::size_t start = out.size();
    out.insert(out.end(), chunk.begin(), chunk.end());
    if (starts_with(name, "IEND")) break;
    if (!starts_with(name, "PLTE") || length >= whole || length % 3 != 0) continue;
    out.insert(out.end() - 4, whole - length, 0);
    out[start + 2] = whole >> 8U;
    out[start + 3] = whole & 0xFFU;
  }
  return out;
}

// Why a PNG's header alone is beyond the limits: stb_image takes many pixels for broken ones.
// Source: W3C PNG (third edition), 11.2.1.
std::optional<PictureFault> beyond_by_header(File png, const PictureLimits& limits) {
  constexpr std::size_t name = 12, width = 16, height = 20, end = 24;
  if (png.size() < end || !starts_with(png.subspan(name), "IHDR")) return std::nullopt;
  const std::size_t size[] = {big_endian(png.subspan(width)), big_endian(png.subspan(height))};
  constexpr std::size_t most = STBI_MAX_DIMENSIONS;  // a side beyond these is broken
  if (size[0] > most || size[1] > most) return std::nullopt;
  return beyond(PictureSize{static_cast<int>(size[0]), static_cast<int>(size[1])}, limits);
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

// The picture's codes, so many channels a pixel, as the member of an image.
template <class Codes>
std::variant<Codes, PictureFault> decode(File file, const PictureLimits& limits, int channels,
                                         Bytes Codes::*codes) {
  const auto measured = measure_picture(file, limits);
  if (const auto* fault = std::get_if<PictureFault>(&measured)) return *fault;
  const auto size = std::get<PictureSize>(measured);
  const Bytes whole = is_png(file) ? mended(file) : Bytes(file.begin(), file.end());
  most_at_once = memory_for(size, whole.size());
  Codes image;
  image.width = size.width;
  image.height = size.height;
  (image.*codes).resize(static_cast<std::size_t>(channels * size.pixels()));
  int width = 0, height = 0, in_file = 0;
  const std::unique_ptr<stbi_uc, Free> decoded(stbi_load_from_memory(
      whole.data(), static_cast<int>(whole.size()), &width, &height, &in_file, channels));
  if (decoded == nullptr || width != size.width || height != size.height) return broken();
  std::memcpy((image.*codes).data(), decoded.get(), (image.*codes).size());
  return image;
}

}  // namespace

bool is_picture(File file) { return is_png(file) || is_jpeg(file); }

std::optional<PictureFault> beyond(std::size_t file_bytes, const PictureLimits& limits) {
  if (file_bytes <= limits.bytes) return std::nullopt;
  return PictureFault{true, std::to_string(file_bytes) + " bytes",
                      "a picture of at most " + std::to_string(limits.bytes) + " bytes"};
}

std::optional<PictureFault> beyond(const PictureSize& size, const PictureLimits& limits) {
  if (size.pixels() <= limits.pixels) return std::nullopt;
  return PictureFault{true,
                      std::to_string(size.width) + " x " + std::to_string(size.height) + " pixels",
                      "a picture of at most " + std::to_string(limits.pixels) + " pixels"};
}

std::variant<PictureSize, PictureFault> measure_picture(File file, const PictureLimits& limits) {
  if (const auto fault = beyond(file.size(), limits)) return *fault;
  if (!is_picture(file))
    return PictureFault{false, "bytes that begin like neither", "a whole PNG or JPEG picture"};
  if (is_jpeg(file) && has_broken_tables(file)) return broken();
  if (is_png(file))
    if (auto fault = beyond_by_header(file, limits)) return *fault;
  PictureSize size;
  int channels = 0;
  most_at_once = memory_for({}, file.size());
  if (stbi_info_from_memory(file.data(), static_cast<int>(file.size()), &size.width, &size.height,
                            &channels) == 0 ||
      size.width < 1 || size.height < 1)
    return broken();
  if (const auto fault = beyond(size, limits)) return *fault;
  if (!is_jpeg(file)) return size;
  size.scans = std::max(1, scans_of(file));
  size.progressive = is_progressive(file);
  const int most = size.progressive ? most_picture_scans : most_sequential_scans;
  if (size.scans > most)
    return PictureFault{true, std::to_string(size.scans) + " scans",
                        std::string(size.progressive ? "a progressive" : "a sequential") +
                            " JPEG of at most " + std::to_string(most) + " scans"};
  return size;
}

std::variant<Image8, PictureFault> decode_picture(File file, const PictureLimits& limits) {
  return decode(file, limits, 3, &Image8::rgb);
}

std::variant<ImageRgba8, PictureFault> decode_picture_rgba(File file, const PictureLimits& limits) {
  return decode(file, limits, 4, &ImageRgba8::rgba);
}

}  // namespace tia
