// JSON text in and out. The parser is nlohmann-json's, behind bounds; the writer is RFC 8785's
// canonical form, so that equal values have equal text.
#pragma once

#include <cstddef>
#include <stop_token>
#include <string>
#include <string_view>

#include "core/input/value.h"

namespace tia {

struct JsonLimits {
  std::size_t depth = 32;                     ///< nested arrays and objects
  std::size_t values = 100'000;               ///< values, numbers inside arrays not counted
  std::string_view option = "TIA_MAX_NODES";  ///< what sets it, for people; "": nothing does
};

/// Errors: InputError of one `malformed` fault, at the place where the text breaks: not JSON,
/// duplicate keys, ill-formed UTF-8, a number beyond double; `limit` beyond the limits. Stopped,
/// some thousand values after that is asked for.
/// Cost: at most 24 bytes of memory for each byte of the text, while it reads and after: 20 where
/// it is numbers, more only for the first `values` values.
Value parse_json(std::string_view text, const JsonLimits& limits = {},
                 const std::stop_token& stop = {});

/// Canonical text: RFC 8785 (JSON Canonicalization Scheme): members sorted by UTF-16 code units,
/// ECMAScript's shortest numbers, no white space. Ill-formed UTF-8 becomes U+FFFD. It gives way.
/// Domain: finite numbers; others are written as null.
std::string to_json(const Value& value);
/// The start of that text: whole where it has at most `enough` bytes, else a little more than
/// those.
std::string start_of_json(const Value& value, std::size_t enough);

/// ECMAScript's Number::toString: the shortest digits that read back as the same double.
std::string number_text(double number);

}  // namespace tia
