#include "core/formulas/tokens.h"

#include <charconv>
#include <limits>

namespace tia {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

std::size_t name_length(std::string_view text) {
  std::size_t n = 0;
  while (n < text.size() && (is_letter(text[n]) || (n > 0 && is_digit(text[n])))) ++n;
  return n;
}
// A character of UTF-8 is named whole.
std::size_t character_length(std::string_view text) {
  constexpr std::size_t longest = 4;
  if (static_cast<unsigned char>(text[0]) < 0xC0U) return 1;
  std::size_t n = 1;
  while (n < text.size() && n < longest && (static_cast<unsigned char>(text[n]) & 0xC0U) == 0x80U)
    ++n;
  return n;
}

}  // namespace

bool is_name(std::string_view text) { return !text.empty() && name_length(text) == text.size(); }

// Of digits with or without a point, and an exponent if digits follow its e.
std::size_t Tokens::number_length() const {
  const std::string_view rest = text_.substr(at_);
  std::size_t n = 0, digits = 0;
  const auto take_digits = [&](std::size_t from) {
    std::size_t to = from;
    while (to < rest.size() && is_digit(rest[to])) ++to;
    digits += to - from;
    return to;
  };
  n = take_digits(0);
  if (n < rest.size() && rest[n] == '.') n = take_digits(n + 1);
  if (digits == 0) return 0;
  if (n < rest.size() && (rest[n] == 'e' || rest[n] == 'E')) {
    std::size_t sign = n + 1;
    if (sign < rest.size() && (rest[sign] == '+' || rest[sign] == '-')) ++sign;
    const std::size_t end = take_digits(sign);
    if (end > sign) n = end;
  }
  return n;
}

Token Tokens::next() {
  while (at_ < text_.size() && is_space(text_[at_])) ++at_;
  Token token;
  token.column = column();
  const std::string_view rest = text_.substr(at_);
  if (rest.empty()) return token;
  std::size_t length = 0;
  if ((length = number_length()) > 0) {
    token.kind = Token::number;
    const auto read = std::from_chars(rest.data(), rest.data() + length, token.value);
    if (read.ec != std::errc()) token.value = std::numeric_limits<double>::infinity();
  } else if ((length = name_length(rest)) > 0) {
    token.kind = Token::name;
  } else {
    token.kind = Token::symbol;
    length = character_length(rest);
  }
  token.text = rest.substr(0, length);
  at_ += length;
  return token;
}

}  // namespace tia
