// The values of headers that have parameters: `form-data; name="a"`.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tia {

/// HeaderValue: a word and its parameters, whose names are lower case as the word is.
struct HeaderValue {
  std::string word;
  std::vector<std::pair<std::string, std::string>> parameters;

  /// The parameter of that name, or null.
  const std::string* find(std::string_view name) const;
};

/// A value read. In quotation marks a '\' before '"' or '\' is left out; any other stays, for
/// browsers and Windows do not write it twice. Returns: nothing where the text is not such a value
/// or has a parameter twice.
/// Cost: n log n. Source: RFC 9110, sections 5.6.4 and 5.6.6.
std::optional<HeaderValue> parse_header_value(std::string_view text);

/// Without spaces and tabs around it.
std::string_view without_blanks(std::string_view text);
/// With 'a' to 'z' for 'A' to 'Z'.
std::string in_lower_case(std::string_view text);
/// Whether it is a token, as names of headers and parameters are. Source: RFC 9110, section 5.6.2.
bool is_header_token(std::string_view text);

}  // namespace tia
