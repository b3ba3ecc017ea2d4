// Base64 text, strictly as RFC 4648 has it.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace tia {

/// Appends the bytes that a text stands for. Padding must be there, unused bits must be zero, and
/// nothing else may stand between. Returns: where the text first goes wrong (its size where it
/// ends too early), nothing where it is good.
/// Source: RFC 4648, sections 3.2, 3.3, 3.5 and 4.
std::optional<std::size_t> decode_base64(std::string_view text, std::vector<std::uint8_t>& bytes);

}  // namespace tia
