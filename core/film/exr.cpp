#include "core/film/exr.h"

#include <libdeflate.h>

#include <bit>
#include <cstring>
#include <string_view>

#include "core/film/compressor.h"
#include "core/film/half.h"

namespace tia {
namespace {

static_assert(std::endian::native == std::endian::little, "EXR is written little-endian");

constexpr int rows_of_block = 16;

template <class T>
void append(std::string& to, T number) {
  std::array<char, sizeof number> bytes;
  std::memcpy(bytes.data(), &number, sizeof number);
  to.append(bytes.data(), bytes.size());
}

// ---- the head -----------------------------------------------------------------------------------

void append_attribute(std::string& to, std::string_view name, std::string_view type,
                      std::string_view value) {
  to.append(name).append(1, '\0').append(type).append(1, '\0');
  append(to, static_cast<std::int32_t>(value.size()));
  to += value;
}

template <class... T>
std::string numbers(T... each) {
  std::string bytes;
  (append(bytes, each), ...);
  return bytes;
}

std::string box(int x0, int y0, int width, int height) {
  return numbers(x0, y0, x0 + width - 1, y0 + height - 1);
}

std::string channel_list(const std::vector<ExrChannel>& channels) {
  std::string list;
  for (const ExrChannel& each : channels) {
    list.append(each.name).append(1, '\0');
    // The four bytes say that it is no logarithm; then the steps between samples.
    list += numbers(static_cast<std::int32_t>(each.type), std::int32_t{0}, 1, 1);
  }
  return list.append(1, '\0');
}

std::string header(const ExrHead& head, const Planes& planes) {
  constexpr char zip = 3, downward = 0;
  std::string out("\x76\x2F\x31\x01\x02\0\0\0", 8);
  append_attribute(out, "channels", "chlist", channel_list(head.channels));
  append_attribute(out, "compression", "compression", {&zip, 1});
  append_attribute(out, "dataWindow", "box2i",
                   box(head.x0, head.y0, planes.width(), planes.height()));
  append_attribute(out, "displayWindow", "box2i", box(0, 0, head.width, head.height));
  append_attribute(out, "lineOrder", "lineOrder", {&downward, 1});
  append_attribute(out, "pixelAspectRatio", "float", numbers(1.0F));
  append_attribute(out, "screenWindowCenter", "v2f", numbers(0.0F, 0.0F));
  append_attribute(out, "screenWindowWidth", "float", numbers(1.0F));
  for (const auto& [name, text] : head.texts) append_attribute(out, name, "string", text);
  return out.append(1, '\0');
}

// ---- blocks of scan lines -----------------------------------------------------------------------

void append_row(std::string& to, const float* row, int width, ExrType type) {
  const auto count = static_cast<std::size_t>(width);
  if (type == ExrType::real)
    return void(to.append(reinterpret_cast<const char*>(row), count * sizeof *row));
  for (std::size_t x = 0; x < count; ++x) {
    if (type == ExrType::half) append(to, half_of(row[x]));
    else append(to, static_cast<std::uint32_t>(row[x]));
  }
}

// The rows' numbers as they are, channel by channel in each row.
std::string plain_block(const ExrHead& head, const Planes& planes, int begin, int end) {
  std::string block;
  std::size_t bytes = 0;
  for (const ExrChannel& each : head.channels) bytes += each.type == ExrType::half ? 2 : 4;
  block.reserve(bytes * static_cast<std::size_t>(planes.width()) *
                static_cast<std::size_t>(end - begin));
  for (int y = begin; y < end; ++y)
    for (const ExrChannel& each : head.channels)
      append_row(block, planes.row(each.plane, y), planes.width(), each.type);
  return block;
}

// Every other byte, then those between, so that alike ones are together; and of each what it is
// more than the one before it, plus 128.
std::string parted(const std::string& block) {
  std::string out(block.size(), '\0');
  std::size_t to = 0;
  unsigned before = 0;
  for (const std::size_t first : {std::size_t{0}, std::size_t{1}})
    for (std::size_t from = first; from < block.size(); from += 2) {
      const unsigned byte = static_cast<unsigned char>(block[from]);
      out[to] = static_cast<char>(to == 0 ? byte : (byte - before + 128U) & 0xFFU);
      before = byte;
      ++to;
    }
  return out;
}

// Where that is no shorter, a block stays as it is.
std::string packed(std::string block) {
  const std::string apart = parted(block);
  std::string out(block.size(), '\0');
  const Compressor compressor;
  const std::size_t bytes = libdeflate_zlib_compress(compressor.get(), apart.data(), apart.size(),
                                                     out.data(), out.size() - 1);
  if (bytes == 0) return block;
  out.resize(bytes);
  out.shrink_to_fit();
  return out;
}

}  // namespace

std::string encode_exr(ExrHead head, const Planes& planes, const Workers& workers) {
  std::ranges::sort(head.channels, {}, &ExrChannel::name);
  std::vector<std::string> blocks(
      static_cast<std::size_t>((planes.height() + rows_of_block - 1) / rows_of_block));
  workers.for_each(static_cast<int>(blocks.size()), [&](int i) {
    const int begin = i * rows_of_block, end = std::min(begin + rows_of_block, planes.height());
    blocks[static_cast<std::size_t>(i)] = packed(plain_block(head, planes, begin, end));
  });

  std::string file = header(head, planes);
  constexpr std::size_t place_bytes = 8, block_head_bytes = 8;
  std::size_t place = file.size() + place_bytes * blocks.size(), bytes = place;
  for (const std::string& each : blocks) bytes += block_head_bytes + each.size();
  file.reserve(bytes);
  for (const std::string& each : blocks) {
    append(file, std::uint64_t{place});
    place += block_head_bytes + each.size();
  }
  int y = head.y0;
  for (std::string& each : blocks) {
    append(file, std::int32_t{y});
    append(file, static_cast<std::int32_t>(each.size()));
    file += std::exchange(each, {});
    y += rows_of_block;
  }
  return file;
}

}  // namespace tia
