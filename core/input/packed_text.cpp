#include "core/input/packed_text.h"

#include <libdeflate.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <new>
#include <optional>
#include <vector>

#include "core/input/base64.h"

namespace tia {
namespace {

constexpr std::string_view packed_words = "a text as zlib (RFC 1950) in base64url (RFC 4648)";

// The same text in the other alphabet, padded; none where it has characters of that one.
std::optional<std::string> as_base64(std::string_view url) {
  std::string text(url);
  for (char& each : text) {
    if (each == '+' || each == '/') return std::nullopt;
    if (each == '-') each = '+';
    if (each == '_') each = '/';
  }
  if (text.ends_with('=')) return text;
  return text.append((4 - text.size() % 4) % 4, '=');
}

struct Free {
  void operator()(libdeflate_decompressor* all) const { libdeflate_free_decompressor(all); }
};

}  // namespace

std::variant<std::string, PackedFault> unpack_text(std::string_view packed) {
  std::vector<std::uint8_t> bytes;
  const auto text = as_base64(packed);
  if (!text || decode_base64(*text, bytes))
    return PackedFault{false, "what is no base64url", std::string(packed_words)};
  const std::size_t most = std::min(most_unpacked_bytes, most_unpacked_times * bytes.size());
  std::string out(most, '\0');
  const std::unique_ptr<libdeflate_decompressor, Free> tool(libdeflate_alloc_decompressor());
  if (!tool) throw std::bad_alloc();
  std::size_t taken = 0, size = 0;
  const auto result = libdeflate_zlib_decompress_ex(tool.get(), bytes.data(), bytes.size(),
                                                    out.data(), out.size(), &taken, &size);
  if (result == LIBDEFLATE_INSUFFICIENT_SPACE)
    return PackedFault{true, "a text that unpacks to more",
                       std::to_string(most_unpacked_bytes) + " bytes, and " +
                           std::to_string(most_unpacked_times) + " times as many as packed"};
  if (result != LIBDEFLATE_SUCCESS || taken != bytes.size())
    return PackedFault{false, "what is no zlib", std::string(packed_words)};
  out.resize(size);
  return out;
}

}  // namespace tia
