#include "core/input/base64.h"

#include <array>

namespace tia {
namespace {

constexpr std::uint8_t none = 64;

constexpr std::array<std::uint8_t, 256> sextets() {
  constexpr std::string_view alphabet =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::array<std::uint8_t, 256> table{};
  for (auto& each : table) each = none;
  for (std::size_t i = 0; i < alphabet.size(); ++i)
    table[static_cast<unsigned char>(alphabet[i])] = static_cast<std::uint8_t>(i);
  return table;
}
constexpr auto sextet_of = sextets();

}  // namespace

std::optional<std::size_t> decode_base64(std::string_view text, std::vector<std::uint8_t>& bytes) {
  std::size_t digits = text.size();
  while (digits > 0 && text.size() - digits < 2 && text[digits - 1] == '=') --digits;
  bytes.reserve(bytes.size() + digits / 4 * 3 + 2);
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < digits; ++i) {
    const std::uint32_t sextet = sextet_of[static_cast<unsigned char>(text[i])];
    if (sextet == none) return i;
    bits = bits << 6U | sextet;  // of four digits the second, third and fourth complete a byte
    if (i % 4 != 0) bytes.push_back(static_cast<std::uint8_t>(bits >> (6 - i % 4 * 2)));
  }
  const std::size_t rest = digits % 4;
  const std::uint32_t unused = rest == 2 ? bits & 15U : rest == 3 ? bits & 3U : 0;
  if (unused != 0) return digits - 1;
  const std::size_t padding = text.size() - digits;
  if (rest == 0 ? padding == 0 : rest + padding == 4) return std::nullopt;
  return rest == 0 || rest + padding > 4 ? digits : text.size();
}

}  // namespace tia
