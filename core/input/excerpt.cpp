// What answers repeat of an input: the start of it, and how much is left out.
#include <algorithm>

#include "core/input/errors.h"
#include "core/input/json.h"
#include "core/input/utf8.h"

namespace tia {
namespace {

// How many bytes a character takes in a JSON string; what is ill-formed becomes U+FFFD.
std::size_t written_bytes(const CodePoint& at) {
  if (at.length == 0) return 3;
  if (at.value == '"' || at.value == '\\') return 2;
  if (at.value >= 0x20) return at.length;
  constexpr std::string_view short_forms = "\b\f\n\r\t";
  return short_forms.find(static_cast<char>(at.value)) != short_forms.npos ? 2 : 6;
}

// How much of a text's start takes at most `most` bytes in a JSON string.
std::size_t fitting(std::string_view text, std::size_t most) {
  std::size_t taken = 0, written = 0;
  while (taken < text.size()) {
    const CodePoint at = decode_utf8(text.substr(taken));
    written += written_bytes(at);
    if (written > most) break;
    taken += std::max<std::size_t>(1, at.length);
  }
  return taken;
}

std::string cut(std::string_view text, std::size_t most, const std::string& left_out) {
  const std::string end = "… (" + left_out + ")";
  return std::string(text.substr(0, fitting(text, most - std::min(most, end.size())))) + end;
}

std::string bytes_more(std::size_t bytes) { return std::to_string(bytes) + " bytes more"; }

}  // namespace

std::string excerpt_of(std::string_view text, std::size_t most) {
  if (fitting(text, most) == text.size()) return std::string(text);
  const std::size_t room = bytes_more(text.size()).size() + std::string_view("… ()").size();
  const std::size_t kept = fitting(text, most - std::min(most, room));
  return std::string(text.substr(0, kept)) + "… (" + bytes_more(text.size() - kept) + ")";
}

Value excerpt(const Value& got) {
  constexpr std::size_t longest = 120;
  if (const auto* string = got.as<std::string>()) {
    if (fitting(*string, longest) == string->size()) return got;
    return excerpt_of(*string, longest);
  }
  const std::string text = start_of_json(got, longest);
  if (text.size() <= longest) return got;
  const auto* list = got.as<Value::Array>();
  const std::size_t count = list != nullptr ? list->size() : got.as<Value::Object>()->size();
  return cut(text, longest,
             (list != nullptr ? "an array of " : "an object of ") + std::to_string(count));
}

}  // namespace tia
