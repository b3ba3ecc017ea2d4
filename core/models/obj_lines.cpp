#include "core/models/obj_lines.h"

#include <algorithm>
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

ObjNumber ObjWords::take(double& number) {
  if (empty()) return ObjNumber::absent;
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
