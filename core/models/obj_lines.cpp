#include "core/models/obj_lines.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

namespace tia {
namespace {

constexpr std::string_view obj_byte_order_mark = "\xEF\xBB\xBF";

// Whether a number that no double is near enough to is too small for one, not too large: by the
// decimal places between its first digit and the point.
bool obj_is_tiny(std::string_view number) {
  const std::size_t end = std::min(number.find_first_of("eE"), number.size());
  const std::size_t digit = number.find_first_of("123456789");
  const std::size_t point = std::min(number.find('.'), end);
  std::string_view exponent = number.substr(std::min(end + 1, number.size()));
  if (exponent.starts_with('+')) exponent.remove_prefix(1);
  std::int64_t places = 0;
  const char* last = exponent.data() + exponent.size();
  if (std::from_chars(exponent.data(), last, places).ec == std::errc::result_out_of_range)
    return exponent.starts_with('-');
  return places + static_cast<std::int64_t>(point) - static_cast<std::int64_t>(digit) < 0;
}

}  // namespace

ObjLines::ObjLines(ModelBytes file)
    : rest_(reinterpret_cast<const char*>(file.data()), file.size()) {
  if (rest_.starts_with(obj_byte_order_mark)) rest_.remove_prefix(obj_byte_order_mark.size());
}

bool ObjLines::next() {
  if (rest_.empty()) return false;
  number_ = taken_ + 1;
  line_ = take();
  if (line_.ends_with('\\')) join();
  return true;
}

std::string_view ObjLines::take() {
  ++taken_;
  const std::size_t end = rest_.find('\n');
  std::string_view line = rest_.substr(0, end);
  rest_.remove_prefix(end == rest_.npos ? rest_.size() : end + 1);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

void ObjLines::join() {
  joined_.clear();
  while (line_.ends_with('\\')) {
    joined_.append(line_.substr(0, line_.size() - 1)).push_back(' ');
    line_ = rest_.empty() ? std::string_view() : take();
  }
  line_ = joined_.append(line_);
}

std::string_view ObjWords::take() {
  if (empty()) return {};
  const char* start = at_;
  while (at_ != end_ && !is_blank(*at_)) ++at_;
  return {start, static_cast<std::size_t>(at_ - start)};
}

// A word that is a decimal number of few digits, as nearly all are: its digits are an integer, and
// that and the power of ten below it are doubles, so that their quotient is the nearest double.
// Returns: its end; null where it is another word.
// Source: Clinger, How to read floating point numbers accurately (1990), section 2.
const char* ObjWords::take_short(double& number) const {
  constexpr std::array powers{1.0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                              1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
  const char* at = at_;
  const bool is_negative = *at == '-';
  if (is_negative) ++at;
  std::uint64_t digits = 0;
  std::size_t count = 0, places = 0;
  const auto take_digits = [&] {
    const char* const start = at;
    for (; at != end_ && *at >= '0' && *at <= '9'; ++at)
      digits = 10 * digits + static_cast<unsigned>(*at - '0');
    return static_cast<std::size_t>(at - start);
  };
  count = take_digits();
  if (at != end_ && *at == '.') {
    ++at;
    places = take_digits();
    count += places;
  }
  if (count == 0 || count >= powers.size() || (at != end_ && !is_blank(*at))) return nullptr;
  const double quotient = static_cast<double>(digits) / powers[places];
  number = is_negative ? -quotient : quotient;
  return at;
}

ObjNumber ObjWords::take(double& number) {
  if (empty()) return ObjNumber::absent;
  if (const char* const end = take_short(number)) {
    at_ = end;
    return ObjNumber::taken;
  }
  const char* start = *at_ == '+' ? at_ + 1 : at_;
  if (start != at_ && start != end_ && *start == '-') return ObjNumber::malformed;
  const auto [end, error] = std::from_chars(start, end_, number);
  if (error == std::errc::invalid_argument || (end != end_ && !is_blank(*end)))
    return ObjNumber::malformed;
  if (error != std::errc()) {
    if (!obj_is_tiny({start, static_cast<std::size_t>(end - start)})) return ObjNumber::too_large;
    number = 0;
  }
  if (!std::isfinite(number)) return ObjNumber::too_large;
  at_ = end;
  return ObjNumber::taken;
}

std::string_view ObjWords::rest() {
  while (at_ != end_ && is_blank(*at_)) ++at_;
  const char* end = end_;
  while (end != at_ && is_blank(end[-1])) --end;
  return {at_, static_cast<std::size_t>(end - at_)};
}

}  // namespace tia
