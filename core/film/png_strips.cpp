// Large pictures: strips that are compressed one by one and joined to one zlib stream.
#include <libdeflate.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <new>
#include <string_view>
#include <vector>

#include "core/film/compressor.h"
#include "core/film/deflate_end.h"
#include "core/film/png.h"
#include "core/film/png_chunk.h"

namespace tia {
namespace {

constexpr std::size_t large_bytes = std::size_t{1} << 20;
// Large enough that what a strip cannot know of the one before is little, small enough that it and
// the compressor's tables stay in a core's cache and that threads finish together.
constexpr std::size_t strip_bytes = std::size_t{1} << 18;

// W3C PNG (third edition), 11.2.1: 8 bits a channel, RGB, the one compression, the one filter
// method, not interlaced.
std::string header(int width, int height) {
  return big_endian(static_cast<std::uint32_t>(width)) +
         big_endian(static_cast<std::uint32_t>(height)) + std::string("\x08\x02\0\0\0", 5);
}

// A raw deflate stream of the bytes that ends, or goes on with whole bytes.
std::string deflate(const std::uint8_t* data, std::size_t bytes, bool ends) {
  constexpr std::string_view empty("\0\0\xFF\xFF", 4);  // of a stored block, behind its 3 bits
  const Compressor compressor;
  const std::size_t bound = libdeflate_deflate_compress_bound(compressor.get(), bytes);
  const auto out = std::make_unique_for_overwrite<std::uint8_t[]>(bound + deflate_end_margin);
  std::size_t written =
      libdeflate_deflate_compress(compressor.get(), data, bytes, out.get(), bound);
  std::string stream;
  if (!ends) {
    std::memset(out.get() + written, 0, deflate_end_margin);
    // As zlib's Z_SYNC_FLUSH does: no block is the last, and an empty stored one fills the byte up.
    const DeflateEnd at = deflate_end(out.get(), written);
    out[at.last_block / 8] &= static_cast<std::uint8_t>(~(1U << at.last_block % 8));
    written = (at.end + 3 + 7) / 8;  // the bits behind the end are 0
  }
  stream.reserve(written + empty.size());
  stream.assign(reinterpret_cast<const char*>(out.get()), written);
  return ends ? stream : stream.append(empty);
}

// The Adler-32 of one text behind another: `first` is that of the one before.
// Source: RFC 1950, 8.2: the low half is 1 + the sum of the bytes, the high half the sum of all
// values of the low one.
std::uint32_t joined(std::uint32_t first, std::uint32_t second, std::size_t second_bytes) {
  constexpr std::uint64_t base = 65521;
  const std::uint64_t low = first & 0xFFFFU, more = (low + base - 1) % base;
  const std::uint64_t high = (first >> 16U) + (second >> 16U) + second_bytes % base * more;
  return static_cast<std::uint32_t>(high % base << 16U | ((second & 0xFFFFU) + more) % base);
}

struct Strip {
  std::string chunk;
  std::uint32_t adler = 0;
  std::size_t bytes = 0;
};

Strip strip(const Scanlines& scanlines, std::size_t i, std::size_t count) {
  const std::uint8_t* const data = scanlines.data() + i * strip_bytes;
  const std::size_t bytes = std::min(strip_bytes, scanlines.size() - i * strip_bytes);
  return {png_chunk("IDAT", deflate(data, bytes, i + 1 == count)),
          libdeflate_adler32(1, data, bytes), bytes};
}

}  // namespace

bool is_cut_in_strips(int width, int height) {
  return (1 + 3 * static_cast<std::size_t>(width)) * static_cast<std::size_t>(height) > large_bytes;
}

std::string encode_png(const Scanlines& scanlines, const Workers& workers) {
  const std::size_t count = (scanlines.size() + strip_bytes - 1) / strip_bytes;
  std::vector<Strip> strips(count);
  workers.for_each(static_cast<int>(count), [&](int i) {
    const auto k = static_cast<std::size_t>(i);
    strips[k] = strip(scanlines, k, count);
  });

  // RFC 1950: a window of 32 KiB, compressed fast; at the end what was compressed is summed up.
  std::string png = std::string(png_signature) +
                    png_chunk("IHDR", header(scanlines.width(), scanlines.height())) +
                    png_chunk("IDAT", "\x78\x5E");
  std::uint32_t adler = 1;
  std::size_t bytes = 64;
  for (const Strip& each : strips) bytes += each.chunk.size();
  png.reserve(png.size() + bytes);
  for (const Strip& each : strips) {
    png += each.chunk;
    adler = joined(adler, each.adler, each.bytes);
  }
  return png += png_chunk("IDAT", big_endian(adler)) + png_chunk("IEND", "");
}

}  // namespace tia
