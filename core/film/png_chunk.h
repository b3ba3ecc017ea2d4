// The chunks that a PNG file is made of. Source: W3C PNG (third edition), 5.3.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace tia {

/// The first bytes of every PNG file.
constexpr std::string_view png_signature = "\x89PNG\r\n\x1A\n";

/// The four bytes of a number, the highest first.
std::string big_endian(std::uint32_t value);

/// Length, type, data, and the CRC of the latter two.
std::string png_chunk(std::string_view type, std::string_view data);

/// Chunk: one of a file's.
struct Chunk {
  std::string_view type, data;
};

/// Takes the next chunk off the bytes of a file behind its signature.
/// Errors: InputError (malformed) for one that is cut short or does not match its checksum.
Chunk take_chunk(std::string_view& bytes);

/// Errors: throws InputError (malformed), saying what came instead of a PNG file.
[[noreturn]] void throw_no_png(const char* got);

}  // namespace tia
