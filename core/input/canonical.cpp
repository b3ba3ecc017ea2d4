// Value -> canonical text, RFC 8785.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

#include "core/input/json.h"
#include "core/input/utf8.h"
#include "core/parallel/stopped.h"

namespace tia {
namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";  // U+FFFD

/// Start: a text that is written until it is long enough.
struct Start {
  std::string text = {};
  std::size_t enough = std::string::npos;
  bool full() const { return text.size() > enough; }
  Start& operator+=(auto more) {
    text += more;
    return *this;
  }
};

void write_string(std::string_view s, Start& out) {
  out += '"';
  while (!s.empty() && !out.full()) {
    const auto [length, value] = decode_utf8(s);
    switch (value) {
      case '"': out += "\\\""; break;
      case '\\': out += "\\\\"; break;
      case '\b': out += "\\b"; break;
      case '\f': out += "\\f"; break;
      case '\n': out += "\\n"; break;
      case '\r': out += "\\r"; break;
      case '\t': out += "\\t"; break;
      default:
        if (length == 0) {
          out += replacement;
        } else if (value < 0x20) {
          constexpr std::string_view hex = "0123456789abcdef";
          out += "\\u00";
          out += hex[value >> 4U];
          out += hex[value & 15U];
        } else {
          out += s.substr(0, length);
        }
    }
    s.remove_prefix(std::max<std::size_t>(1, length));
  }
  out += '"';
}

// UTF-16 order is UTF-8's order but for the surrogates: U+E000..U+FFFF sort after U+10000 and up.
bool utf16_less(std::string_view a, std::string_view b) {
  const auto rank = [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte >= 0xF0 ? byte - 2 : byte >= 0xEE ? byte + 5 : static_cast<int>(byte);
  };
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(),
                                      [&](char x, char y) { return rank(x) < rank(y); });
}

void write(const Value& value, Start& out);

void write_array(const Value::Array& array, Start& out) {
  out += '[';
  for (std::size_t i = 0; i < array.size() && !out.full(); ++i) {
    if (i % 1024 == 0) give_way();
    if (i > 0) out += ',';
    write(array[i], out);
  }
  out += ']';
}

void write_object(const Value::Object& object, Start& out) {
  std::vector<const Value::Member*> sorted;
  sorted.reserve(object.size());
  for (const auto& member : object) sorted.push_back(&member);
  give_way();
  std::sort(sorted.begin(), sorted.end(),
            [](const auto* a, const auto* b) { return utf16_less(a->first, b->first); });
  out += '{';
  for (const auto* member : sorted) {
    if (out.full()) break;
    if (member != sorted.front()) out += ',';
    write_string(member->first, out);
    out += ':';
    write(member->second, out);
  }
  out += '}';
}

void write(const Value& value, Start& out) {
  if (const auto* b = value.as<bool>()) out += *b ? "true" : "false";
  else if (const auto* d = value.as<double>()) out += number_text(*d);
  else if (const auto* s = value.as<std::string>()) write_string(*s, out);
  else if (const auto* a = value.as<Value::Array>()) write_array(*a, out);
  else if (const auto* o = value.as<Value::Object>()) write_object(*o, out);
  else out += "null";
}

}  // namespace

// ECMA-262, Number::toString, with the shortest digits from std::to_chars.
std::string number_text(double number) {
  if (!std::isfinite(number)) return "null";
  if (number == 0) return "0";
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), std::fabs(number),
                                 std::chars_format::scientific);
  const std::string_view text(buffer.data(), static_cast<std::size_t>(end.ptr - buffer.data()));
  const std::size_t e = text.find('e');  // d.ddde+XX
  std::string digits(1, text[0]);
  if (e > 2) digits += text.substr(2, e - 2);
  int exponent = 0;
  std::from_chars(text.data() + e + (text[e + 1] == '+' ? 2 : 1), text.data() + text.size(),
                  exponent);

  const int k = static_cast<int>(digits.size());
  const int n = exponent + 1;  // the value is 0.digits x 10^n
  std::string out = number < 0 ? "-" : "";
  if (k <= n && n <= 21) return out + digits + std::string(static_cast<std::size_t>(n - k), '0');
  if (0 < n && n <= 21) {
    const auto whole = static_cast<std::size_t>(n);
    return out.append(digits, 0, whole).append(1, '.').append(digits, whole);
  }
  if (-6 < n && n <= 0) return out.append("0.").append(static_cast<std::size_t>(-n), '0') + digits;
  out += digits[0];
  if (k > 1) out.append(1, '.').append(digits, 1);
  return out + (n > 0 ? "e+" : "e-") + std::to_string(std::abs(n - 1));
}

std::string to_json(const Value& value) { return start_of_json(value, std::string::npos); }

std::string start_of_json(const Value& value, std::size_t enough) {
  Start out{{}, enough};
  write(value, out);
  return std::move(out.text);
}

}  // namespace tia
