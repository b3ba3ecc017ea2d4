#include "core/film/decode_hdr.h"

#include <charconv>
#include <optional>
#include <string_view>
#include <utility>

namespace tia {
namespace {

using File = std::span<const std::uint8_t>;
using Pixel = std::array<std::uint8_t, 4>;

PictureFault broken_hdr() {
  return {false, "bytes that cannot be decoded", "a whole Radiance HDR picture (RGBE, -Y +X)"};
}

std::string_view text_of(File file) {
  return {reinterpret_cast<const char*>(file.data()), file.size()};
}

// The next line, without its end, which is taken off the text; none where there is no end.
std::optional<std::string_view> take_line(std::string_view& text) {
  const std::size_t end = text.find('\n');
  if (end == text.npos) return std::nullopt;
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end + 1);
  return line;
}
bool take_word(std::string_view& text, std::string_view word) {
  if (!text.starts_with(word)) return false;
  text.remove_prefix(word.size());
  return true;
}
bool take_number(std::string_view& text, int& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || number < 1 || number > 1 << 20) return false;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return true;
}

struct Head {
  PictureSize size;
  File rows;
};
std::optional<Head> head_of(File file) {
  std::string_view text = text_of(file);
  bool is_rgbe = false;
  for (auto line = take_line(text); line && !line->empty(); line = take_line(text))
    is_rgbe = is_rgbe || *line == "FORMAT=32-bit_rle_rgbe";
  auto line = take_line(text);
  Head head;
  if (!is_rgbe || !line || !take_word(*line, "-Y ") || !take_number(*line, head.size.height) ||
      !take_word(*line, " +X ") || !take_number(*line, head.size.width) || !line->empty())
    return std::nullopt;
  head.rows = file.last(text.size());
  return head;
}

/// Rows: reads one after the other; false where the file does not hold it.
class Rows {
 public:
  explicit Rows(File file) : left_(file) {}

  bool read(std::span<Pixel> row) {
    const std::size_t width = row.size();
    const bool in_planes = width >= 8 && width < 32768 && left_.size() >= 4 && left_[0] == 2 &&
                           left_[1] == 2 && left_[2] < 128;
    if (!in_planes) return read_pixels(row);
    if (std::size_t{left_[2]} << 8U != (width & 0xFF00U) || left_[3] != (width & 0xFFU))
      return false;
    left_ = left_.subspan(4);
    for (std::size_t plane = 0; plane < 4; ++plane)
      if (!read_plane(row, plane)) return false;
    return true;
  }

 private:
  // A count up to 128 with as many bytes, or 128 more than a count with one byte that is repeated.
  bool read_plane(std::span<Pixel> row, std::size_t plane) {
    for (std::size_t x = 0; x < row.size();) {
      if (left_.empty()) return false;
      const bool is_run = left_[0] > 128;
      const std::size_t count = is_run ? left_[0] - 128U : left_[0], bytes = is_run ? 1 : count;
      if (count == 0 || count > row.size() - x || bytes > left_.size() - 1) return false;
      for (std::size_t i = 0; i < count; ++i) row[x + i][plane] = left_[is_run ? 1 : 1 + i];
      left_ = left_.subspan(1 + bytes);
      x += count;
    }
    return true;
  }
  // Four bytes each; in the old way three ones and a count repeat the last pixel, by the count, and
  // where several of these follow each other by 256 times as much with each.
  bool read_pixels(std::span<Pixel> row) {
    unsigned shift = 0;
    for (std::size_t x = 0; x < row.size(); left_ = left_.subspan(4)) {
      if (left_.size() < 4) return false;
      const Pixel pixel{left_[0], left_[1], left_[2], left_[3]};
      if (pixel[0] != 1 || pixel[1] != 1 || pixel[2] != 1) {
        row[x++] = pixel;
        shift = 0;
        continue;
      }
      const std::size_t count = shift < 32 ? std::size_t{pixel[3]} << shift : row.size();
      if (x == 0 || count > row.size() - x) return false;
      for (const std::size_t end = x + count; x < end; ++x) row[x] = row[x - 1];
      shift += 8;
    }
    return true;
  }

  File left_;
};

}  // namespace

bool is_hdr(File file) {
  return text_of(file).starts_with("#?RADIANCE\n") || text_of(file).starts_with("#?RGBE\n");
}

std::variant<PictureSize, PictureFault> measure_hdr(File file, const PictureLimits& limits) {
  if (const auto fault = beyond(file.size(), limits)) return *fault;
  const auto head = is_hdr(file) ? head_of(file) : std::nullopt;
  if (!head) return broken_hdr();
  if (const auto fault = beyond(head->size, limits)) return *fault;
  return head->size;
}

std::variant<RgbeImage, PictureFault> decode_hdr(File file, const PictureLimits& limits) {
  const auto measured = measure_hdr(file, limits);
  if (const auto* fault = std::get_if<PictureFault>(&measured)) return *fault;
  const Head head = *head_of(file);
  const auto width = static_cast<std::size_t>(head.size.width);
  RgbeImage image{head.size.width, head.size.height, {}};
  image.pixels.resize(width * static_cast<std::size_t>(head.size.height));
  Rows rows(head.rows);
  for (std::size_t at = 0; at < image.pixels.size(); at += width)
    if (!rows.read(std::span(image.pixels).subspan(at, width))) return broken_hdr();
  return image;
}

}  // namespace tia
