#include "core/models/text_words.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace tia {
namespace {

constexpr double text_infinity = std::numeric_limits<double>::infinity();

// Of a number that no double is near. The digits of a short one are within 10^64 of 1, so that its
// exponent's sign tells which it is; a longer one is refused by its being infinite.
double too_large_or_small(std::string_view word) {
  constexpr std::size_t is_long = 64;
  const bool small = word.size() <= is_long && word.find_first_of("eE") != word.npos &&
                     word[word.find_first_of("eE") + 1] == '-';
  return small ? 0 : word[0] == '-' ? -text_infinity : text_infinity;
}

char small_letter(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

}  // namespace

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_white(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_white(text.back())) text.remove_suffix(1);
  return text;
}

bool is_word(std::string_view word, std::string_view small) {
  return std::equal(word.begin(), word.end(), small.begin(), small.end(),
                    [](char a, char b) { return small_letter(a) == b; });
}

std::optional<double> number_in(std::string_view word) {
  if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
  double number = 0;
  const char* const end = word.data() + word.size();
  const auto read = std::from_chars(word.data(), end, number);
  if (read.ptr != end || read.ec == std::errc::invalid_argument) return std::nullopt;
  return read.ec == std::errc() ? number : too_large_or_small(word);
}

Value shown_number(double number) {
  if (std::isfinite(number)) return {number};
  return {std::isnan(number) ? "nan" : number < 0 ? "-inf" : "inf"};
}

}  // namespace tia
