// The words of a formula, one after the other.
#pragma once

#include <string_view>

namespace tia {

struct Token {
  enum Kind { number, name, symbol, end } kind = end;
  std::string_view text{};
  std::size_t column = 1;  ///< from 1, in bytes
  double value = 0;        ///< of a number; infinite where it is too great or small for one

  bool is(char one) const { return kind == symbol && text[0] == one; }
};

/// A letter or _, then letters, digits and _ (ASCII).
bool is_name(std::string_view text);

/// Tokens: a text's words. What can be none is a symbol: a whole character, if not one byte.
class Tokens {
 public:
  explicit Tokens(std::string_view text) : text_(text) {}
  Token next();
  /// Of what comes next.
  std::size_t column() const { return at_ + 1; }

 private:
  std::size_t number_length() const;
  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace tia
