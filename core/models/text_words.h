// Words, lines and numbers in the texts of models.
#pragma once

#include <optional>
#include <string_view>

#include "core/input/value.h"

namespace tia {

/// How far from the origin along an axis what is read may lie.
inline constexpr double most_coordinate = 1e9;

inline bool is_white(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

/// Takes white space and the word after it off a text. Returns: the word, "" where there is none.
inline std::string_view cut_word(std::string_view& text) {
  std::size_t start = 0;
  while (start < text.size() && is_white(text[start])) ++start;
  std::size_t end = start;
  while (end < text.size() && !is_white(text[end])) ++end;
  const std::string_view word = text.substr(start, end - start);
  text.remove_prefix(end);
  return word;
}

/// Takes a line and its end off a text; the last line may lack the end. Returns: it without.
inline std::string_view cut_line(std::string_view& text, char end) {
  const std::string_view line = text.substr(0, text.find(end));
  text.remove_prefix(line.size() == text.size() ? line.size() : line.size() + 1);
  return line;
}

/// The text without white space around it.
std::string_view trimmed(std::string_view text);

/// Whether the word is that one, in letters of any case. Domain: a word in small letters.
bool is_word(std::string_view word, std::string_view small);

/// The number that all of a word is, to the nearest double; '+' may stand before it. Returns: none
/// where it is not a number; what is too large is infinite, what is too small is 0.
std::optional<double> number_in(std::string_view word);

/// A number as a fault shows it: JSON has none that is not finite, so those are words.
Value shown_number(double number);

}  // namespace tia
