#include "server/access/key_entry.h"

#include <algorithm>
#include <chrono>

namespace tia::server {
namespace {

bool is_all_of(std::string_view text, std::string_view characters) {
  return text.find_first_not_of(characters) == text.npos;
}

// The number that so many digits from there on are, or -1.
int number_in(const std::string& text, std::size_t at, std::size_t digits) {
  const std::string part = text.substr(at, digits);
  return is_all_of(part, "0123456789") ? std::stoi(part) : -1;
}

}  // namespace

std::optional<KeyId> KeyId::parse(const std::string& text) {
  constexpr std::string_view allowed =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
  if (text.empty() || text.size() > 64 || !is_all_of(text, allowed) || text == "other")
    return std::nullopt;
  return KeyId{text};
}

std::optional<UtcTime> UtcTime::parse(const std::string& text) {
  constexpr std::string_view shape = "dddd-dd-ddTdd:dd:ddZ";
  if (text.size() != shape.size()) return std::nullopt;
  for (std::size_t i = 0; i < shape.size(); ++i)
    if (shape[i] != 'd' && text[i] != shape[i]) return std::nullopt;
  const int year = number_in(text, 0, 4), month = number_in(text, 5, 2),
            day = number_in(text, 8, 2), hour = number_in(text, 11, 2),
            minute = number_in(text, 14, 2), second = number_in(text, 17, 2);
  const auto in = [](int value, int most) { return value >= 0 && value <= most; };
  if (year < 1970 || month < 0 || day < 0 || !in(hour, 23) || !in(minute, 59) || !in(second, 59))
    return std::nullopt;
  const std::chrono::year_month_day date{std::chrono::year(year),
                                         std::chrono::month(static_cast<unsigned>(month)),
                                         std::chrono::day(static_cast<unsigned>(day))};
  if (!date.ok()) return std::nullopt;
  const auto days = std::chrono::sys_days(date).time_since_epoch().count();
  return UtcTime{text, ((std::int64_t{days} * 24 + hour) * 60 + minute) * 60 + second};
}

void KeyEntry::check(const Place& at, Faults& faults) const {
  const std::string place = at.at("sha256").pointer();
  const char* const form = "the secret's SHA-256, 64 hexadecimal digits, a to f small";
  if (is_anonymous() && sha256)
    faults.add({FaultKind::conflict, place, Value("one"),
                "none: anonymous is whoever comes without a key"});
  else if (!is_anonymous() && !sha256) faults.add({FaultKind::missing, place, std::nullopt, form});
  else if (sha256 && (sha256->size() != 64 || !is_all_of(*sha256, "0123456789abcdef")))
    faults.add({FaultKind::out_of_range, place, Value("another text"), form});
  if (burst && !requests_per_s)
    faults.add({FaultKind::conflict, at.at("burst").pointer(), Value(*burst),
                "a burst of what requests_per_s gives"});
}

bool KeyEntry::has(Right right) const { return std::ranges::find(may, right) != may.end(); }

}  // namespace tia::server
