#include "core/film/png_chunk.h"

#include <libdeflate.h>

#include "core/input/errors.h"

namespace tia {
namespace {

std::uint32_t number_at(std::string_view bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (const char c : bytes.substr(at, 4)) number = number << 8U | static_cast<unsigned char>(c);
  return number;
}

}  // namespace

void throw_no_png(const char* got) {
  throw InputError({FaultKind::malformed, "", Value(got), "a whole PNG file"});
}

std::string big_endian(std::uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xFFU);
  return bytes;
}

std::string png_chunk(std::string_view type, std::string_view data) {
  std::string bytes = big_endian(static_cast<std::uint32_t>(data.size()));
  bytes.reserve(data.size() + 12);
  bytes.append(type).append(data);
  return bytes += big_endian(libdeflate_crc32(0, bytes.data() + 4, bytes.size() - 4));
}

Chunk take_chunk(std::string_view& bytes) {
  constexpr std::size_t around = 12;  // length, type, checksum
  if (bytes.size() < around) throw_no_png("a file that is cut short");
  const std::size_t size = number_at(bytes, 0);
  if (bytes.size() - around < size) throw_no_png("a file that is cut short");
  const std::string_view summed = bytes.substr(4, 4 + size);
  if (libdeflate_crc32(0, summed.data(), summed.size()) != number_at(bytes, 8 + size))
    throw_no_png("a chunk that does not match its checksum");
  bytes.remove_prefix(around + size);
  return {summed.substr(0, 4), summed.substr(4)};
}

}  // namespace tia
