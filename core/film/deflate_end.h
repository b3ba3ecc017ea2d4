// Where a raw deflate stream ends, to the bit: what joining it to another stream takes. Nothing is
// decompressed.
#pragma once

#include <cstddef>
#include <cstdint>

namespace tia {

/// DeflateEnd: the two places that tell a stream that ends from one that goes on.
/// Space/units: bits from the stream's start, each byte's lowest first.
struct DeflateEnd {
  std::size_t last_block;  ///< the bit BFINAL of the last block: clear it, and the stream goes on
  std::size_t end;         ///< the first bit behind that block
};

/// How many bytes behind a stream must be readable.
inline constexpr std::size_t deflate_end_margin = 16;

/// Returns: where the stream of at most `bytes` bytes ends.
/// Domain: what an encoder has made. Errors: std::invalid_argument if no end is found in it.
/// Cost: its codes are read one by one, which takes about a tenth of the time that made them.
/// Source: RFC 1951, P. Deutsch, "DEFLATE Compressed Data Format Specification", 1996, section 3.2.
DeflateEnd deflate_end(const std::uint8_t* stream, std::size_t bytes);

}  // namespace tia
