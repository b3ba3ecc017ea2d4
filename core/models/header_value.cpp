#include "core/models/header_value.h"

#include <algorithm>

namespace tia {
namespace {

bool is_visible_ascii(char c) { return c > ' ' && c < 0x7F; }
bool is_header_token_character(char c) {
  return is_visible_ascii(c) &&
         std::string_view("\"(),/:;<=>?@[\\]{}").find(c) == std::string_view::npos;
}
// What values that are not quoted may have: more than tokens, for boundaries have more.
bool is_bare_in_header(char c) { return is_visible_ascii(c) && c != '"' && c != ';' && c != '\\'; }

// The text between quotation marks at the front, which is taken off with them; none where they are
// not closed.
std::optional<std::string> take_quoted_value(std::string_view& text) {
  std::string value;
  for (std::size_t i = 1; i < text.size(); ++i) {
    const bool escape =
        text[i] == '\\' && i + 1 < text.size() && (text[i + 1] == '"' || text[i + 1] == '\\');
    if (escape) {
      value += text[++i];
    } else if (text[i] == '"') {
      text.remove_prefix(i + 1);
      return value;
    } else {
      value += text[i];
    }
  }
  return std::nullopt;
}

// What stands up to the next ';' or end, which is taken off the front; none where it is not a
// value.
std::optional<std::string> take_header_value(std::string_view& text) {
  std::optional<std::string> value;
  if (text.starts_with('"')) {
    value = take_quoted_value(text);
  } else {
    const std::string_view bare = without_blanks(text.substr(0, text.find(';')));
    if (!bare.empty() && std::ranges::all_of(bare, is_bare_in_header)) value = bare;
    text.remove_prefix(bare.size());  // of blanks before it something is left, which is refused
  }
  text = without_blanks(text);
  return text.empty() || text.starts_with(';') ? value : std::nullopt;
}

bool has_parameter_twice(const HeaderValue& value) {
  std::vector<std::string_view> names;
  for (const auto& [name, unused] : value.parameters) names.push_back(name);
  std::ranges::sort(names);
  return std::ranges::adjacent_find(names) != names.end();
}

}  // namespace

const std::string* HeaderValue::find(std::string_view name) const {
  for (const auto& [key, value] : parameters)
    if (key == name) return &value;
  return nullptr;
}

std::optional<HeaderValue> parse_header_value(std::string_view text) {
  const std::size_t word = std::min(text.size(), text.find(';'));
  HeaderValue value{in_lower_case(without_blanks(text.substr(0, word))), {}};
  text.remove_prefix(word);
  while (!text.empty()) {  // a ';', and a parameter or nothing
    text = without_blanks(text.substr(1));
    if (text.empty() || text.starts_with(';')) continue;
    const std::string_view name = text.substr(0, text.find('='));
    if (!is_header_token(name) || name.size() == text.size()) return std::nullopt;
    text.remove_prefix(name.size() + 1);
    auto parameter = take_header_value(text);
    if (!parameter) return std::nullopt;
    value.parameters.emplace_back(in_lower_case(name), std::move(*parameter));
  }
  return has_parameter_twice(value) ? std::nullopt : std::optional(std::move(value));
}

std::string_view without_blanks(std::string_view text) {
  constexpr std::string_view blanks = " \t";
  text.remove_prefix(std::min(text.size(), text.find_first_not_of(blanks)));
  return text.substr(0, text.find_last_not_of(blanks) + 1);  // npos + 1 = 0
}

std::string in_lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return lower;
}

bool is_header_token(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, is_header_token_character);
}

}  // namespace tia
