// What a URI of a glTF document means: bytes that it holds itself, or a file that came beside.
#include <optional>

#include "core/input/base64.h"
#include "core/models/gltf/gltf_parts.h"

namespace tia::gltf {
namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Source: RFC 3986, section 3.1.
std::string_view scheme_of(std::string_view uri) {
  std::size_t end = 0;
  while (end < uri.size() &&
         (is_letter(uri[end]) ||
          (end > 0 && (is_digit(uri[end]) || std::string_view("+-.").find(uri[end]) != uri.npos))))
    ++end;
  return end > 0 && end < uri.size() && uri[end] == ':' ? uri.substr(0, end) : std::string_view();
}

bool is_data(std::string_view scheme) {
  constexpr std::string_view data = "data";
  if (scheme.size() != data.size()) return false;
  for (std::size_t i = 0; i < data.size(); ++i)
    if ((scheme[i] | 0x20) != data[i]) return false;
  return true;
}

std::optional<unsigned> hex_digit(char c) {
  if (is_digit(c)) return static_cast<unsigned>(c - '0');
  const char lower = static_cast<char>(c | 0x20);
  if (lower >= 'a' && lower <= 'f') return static_cast<unsigned>(lower - 'a') + 10;
  return std::nullopt;
}

// %20 becomes a space; a % that begins no such thing stays one.
std::string percent_decoded(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '%' && text.size() - i > 2) {
      const auto high = hex_digit(text[i + 1]), low = hex_digit(text[i + 2]);
      if (high && low) {
        out += static_cast<char>(*high << 4U | *low);
        i += 2;
        continue;
      }
    }
    out += text[i];
  }
  return out;
}

// Of any media type: what the bytes are is told by themselves.
ModelBytes data_bytes(std::string_view uri, const Place& at, Faults& faults,
                      std::vector<std::uint8_t>& own) {
  const std::size_t comma = uri.find(',');
  if (comma == uri.npos || !uri.substr(0, comma).ends_with(";base64")) {
    faults.add({FaultKind::malformed, at.pointer(), excerpt(std::string(uri.substr(0, 200))),
                "a data URI in base64: data:TYPE;base64,TEXT"});
    return {};
  }
  if (const auto wrong = decode_base64(uri.substr(comma + 1), own)) {
    faults.add({FaultKind::malformed, at.pointer(), std::nullopt,
                "base64 (RFC 4648), which the text is not from byte " +
                    std::to_string(*wrong + comma + 1) + " on"});
    own.clear();
  }
  return own;
}

}  // namespace

ModelBytes uri_bytes(const ModelFiles& files, std::string_view uri, const Place& at, Faults& faults,
                     std::vector<std::uint8_t>& own) {
  const std::string_view scheme = scheme_of(uri);
  if (is_data(scheme)) return data_bytes(uri, at, faults, own);
  if (!scheme.empty() || uri.starts_with('/')) {
    faults.add({FaultKind::out_of_range, at.pointer(), excerpt(std::string(uri.substr(0, 200))),
                "the name of a file beside this one: only what came along is read"});
    return {};
  }
  // Some writers do not encode what they name: then the name is the text itself.
  const std::string name = percent_decoded(uri), from = files.main_file().path;
  const ModelFile* file = files.find(name, from);
  if (file == nullptr && name != uri) file = files.find(uri, from);
  if (file != nullptr) return file->bytes;
  faults.add({FaultKind::missing, at.pointer(), excerpt(name), "a file of that name, sent along"});
  return {};
}

}  // namespace tia::gltf
