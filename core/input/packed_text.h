// Packed text: a text that stands in a URL as Kroki has it: base64url of its zlib.
#pragma once

#include <string>
#include <string_view>
#include <variant>

namespace tia {

/// The most that a packed text may unpack to: so many bytes, and so many times its own.
inline constexpr std::size_t most_unpacked_bytes = 1 << 20, most_unpacked_times = 100;

/// PackedFault: why a text is not unpacked, in words.
struct PackedFault {
  bool beyond_limits = false;  ///< else it is no packed text
  std::string got, allowed;
};

/// Returns: the text, whose checksum was looked at. Padding (`=`) may be left out.
/// Cost: memory for what it may unpack to. Source: RFC 4648, section 5; RFC 1950.
std::variant<std::string, PackedFault> unpack_text(std::string_view packed);

}  // namespace tia
