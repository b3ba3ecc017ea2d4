#include "core/film/tiff.h"

#include <bit>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/parallel/stopped.h"

namespace tia {
namespace {

static_assert(std::endian::native == std::endian::little, "TIFF is written little-endian");

enum class TiffType : std::uint16_t { shorts = 3, longs = 4, rational = 5 };

/// TiffEntry: what a tag says. What takes more than four bytes stands behind the directory.
struct TiffEntry {
  std::uint16_t tag;
  TiffType type;
  std::vector<std::uint32_t> values;
};

void put_number(std::string& out, std::uint32_t value, int bytes) {
  for (int i = 0; i < bytes; ++i, value >>= 8U) out += static_cast<char>(value & 0xFFU);
}

// Of the values of an entry; a rational is two longs.
int tiff_bytes_of(TiffType type) { return type == TiffType::shorts ? 2 : 4; }
std::string entry_bytes(const TiffEntry& entry) {
  std::string bytes;
  for (const std::uint32_t value : entry.values)
    put_number(bytes, value, tiff_bytes_of(entry.type));
  return bytes;
}

// Tags in ascending order, as they must be; where the strip begins is known to whoever calls.
std::vector<TiffEntry> tiff_entries(const Image& image, std::uint32_t channels,
                                    std::uint32_t strip_at) {
  const auto width = static_cast<std::uint32_t>(image.width);
  const auto height = static_cast<std::uint32_t>(image.height);
  using enum TiffType;
  const auto each = [&](std::uint32_t value) {
    return std::vector<std::uint32_t>(channels, value);
  };
  return {{256, longs, {width}},
          {257, longs, {height}},
          {258, shorts, each(32)},                        // BitsPerSample
          {259, shorts, {1}},                             // Compression: none
          {262, shorts, {channels == 1 ? 1U : 2U}},       // Photometric: black is zero, RGB
          {273, longs, {strip_at}},                       // StripOffsets
          {274, shorts, {1}},                             // Orientation: row 0 on top
          {277, shorts, {channels}},                      // SamplesPerPixel
          {278, longs, {height}},                         // RowsPerStrip
          {279, longs, {width * height * channels * 4}},  // StripByteCounts
          {282, rational, {1, 1}},                        // XResolution
          {283, rational, {1, 1}},                        // YResolution
          {284, shorts, {1}},                             // PlanarConfiguration: pixel by pixel
          {296, shorts, {1}},                             // ResolutionUnit: none
          {339, shorts, each(3)}};                        // SampleFormat: IEEE float
}

// The head, the directory and what stands behind it, up to the strip.
std::string tiff_head(const std::vector<TiffEntry>& entries) {
  std::string head("II"), behind;
  put_number(head, 42, 2), put_number(head, 8, 4);
  put_number(head, static_cast<std::uint32_t>(entries.size()), 2);
  const std::size_t end = head.size() + 12 * entries.size() + 4;
  for (const TiffEntry& entry : entries) {
    const std::size_t count = entry.values.size() / (entry.type == TiffType::rational ? 2 : 1);
    put_number(head, entry.tag, 2), put_number(head, static_cast<std::uint32_t>(entry.type), 2);
    put_number(head, static_cast<std::uint32_t>(count), 4);
    std::string bytes = entry_bytes(entry);
    if (bytes.size() <= 4) {
      bytes.resize(4);
      head += bytes;
    } else {
      put_number(head, static_cast<std::uint32_t>(end + behind.size()), 4);
      behind += bytes;
      behind.resize((behind.size() + 3) / 4 * 4);
    }
  }
  put_number(head, 0, 4);  // no other directory
  return head + behind;
}

}  // namespace

std::string encode_tiff(const Image& image, int channels, const std::stop_token& stop) {
  const auto of_pixel = static_cast<std::uint32_t>(channels);
  const std::size_t strip_at = tiff_head(tiff_entries(image, of_pixel, 0)).size();
  std::string out = tiff_head(tiff_entries(image, of_pixel, static_cast<std::uint32_t>(strip_at)));
  const auto width = static_cast<std::size_t>(image.width);
  out.reserve(out.size() + width * static_cast<std::size_t>(image.height) * of_pixel * 4);
  std::vector<float> row(width * of_pixel);
  for (int y = 0; y < image.height; ++y) {
    end_if_asked(stop);
    for (std::size_t i = 0; i < row.size(); ++i)
      row[i] = image.at(0, y)[i / of_pixel * 3 + i % of_pixel];
    out.append(reinterpret_cast<const char*>(row.data()), row.size() * sizeof(float));
  }
  return out;
}

}  // namespace tia
