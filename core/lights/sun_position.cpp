#include "core/lights/sun_position.h"

#include <array>
#include <cmath>

#include "core/math/deterministic.h"
#include "core/math/onb.h"

namespace tia {
namespace {

// ---- JSON -----------------------------------------------------------------------------------

constexpr std::string_view date_words = "a date from \"1900-01-01\" to \"2099-12-31\"";
constexpr std::string_view time_words = "a time from \"00:00\" to \"23:59\", perhaps with seconds";

// The number that two digits there are; none where they are no digits.
std::optional<int> two_digits(std::string_view text, std::size_t at) {
  const auto digit = [&](std::size_t i) { return text[i] >= '0' && text[i] <= '9'; };
  if (!digit(at) || !digit(at + 1)) return std::nullopt;
  return 10 * (text[at] - '0') + (text[at + 1] - '0');
}
std::string two_digits(int number) {
  return {static_cast<char>('0' + number / 10), static_cast<char>('0' + number % 10)};
}
bool between(const std::optional<int>& number, int least, int most) {
  return number && *number >= least && *number <= most;
}

std::optional<CalendarDate> date_of(std::string_view text) {
  if (text.size() != 10 || text[4] != '-' || text[7] != '-') return std::nullopt;
  const auto century = two_digits(text, 0), year = two_digits(text, 2), month = two_digits(text, 5),
             day = two_digits(text, 8);
  if (!between(century, 19, 20) || !year || !between(month, 1, 12) || !between(day, 1, 31))
    return std::nullopt;
  return CalendarDate{100 * *century + *year, *month, *day};
}
std::optional<ClockTime> time_of(std::string_view text) {
  if ((text.size() != 5 && text.size() != 8) || text[2] != ':') return std::nullopt;
  const bool has_seconds = text.size() == 8;
  if (has_seconds && text[5] != ':') return std::nullopt;
  const auto hour = two_digits(text, 0), minute = two_digits(text, 3),
             second = has_seconds ? two_digits(text, 6) : std::optional(0);
  if (!between(hour, 0, 23) || !between(minute, 0, 59) || !between(second, 0, 59))
    return std::nullopt;
  return ClockTime{3600 * *hour + 60 * *minute + *second};
}

template <class T, class Parse>
void read_text(const Value& v, const Place& at, std::string_view words, Faults& faults, T& out,
               Parse parse) {
  const auto* text = v.as<std::string>();
  const auto read = text != nullptr ? parse(*text) : std::nullopt;
  if (read) out = *read;
  else detail::wrong_type(v, at, std::string(words), faults);
}

}  // namespace

void Codec<CalendarDate>::read(const Value& v, const Place& at, const Spec&, Faults& faults,
                               CalendarDate& out) {
  read_text(v, at, date_words, faults, out, date_of);
}
Value Codec<CalendarDate>::write(const CalendarDate& v) {
  return two_digits(v.year / 100) + two_digits(v.year % 100) + "-" + two_digits(v.month) + "-" +
         two_digits(v.day);
}
Value Codec<CalendarDate>::schema(const Spec&) {
  return Value::Object{{"type", "string"},
                       {"pattern", "^(19|20)[0-9][0-9]-(0[1-9]|1[0-2])-(0[1-9]|[12][0-9]|3[01])$"},
                       {"examples", Value::Array{"2026-06-21"}}};
}
std::string Codec<CalendarDate>::allowed(const Spec&) { return std::string(date_words); }

void Codec<ClockTime>::read(const Value& v, const Place& at, const Spec&, Faults& faults,
                            ClockTime& out) {
  read_text(v, at, time_words, faults, out, time_of);
}
Value Codec<ClockTime>::write(const ClockTime& v) {
  const std::string text = two_digits(v.seconds / 3600) + ":" + two_digits(v.seconds / 60 % 60);
  return v.seconds % 60 == 0 ? text : text + ":" + two_digits(v.seconds % 60);
}
Value Codec<ClockTime>::schema(const Spec&) {
  return Value::Object{{"type", "string"},
                       {"pattern", "^([01][0-9]|2[0-3]):[0-5][0-9](:[0-5][0-9])?$"},
                       {"examples", Value::Array{"12:00"}}};
}
std::string Codec<ClockTime>::allowed(const Spec&) { return std::string(time_words); }

// ---- the calendar ---------------------------------------------------------------------------

bool exists(const CalendarDate& date) {
  constexpr std::array days{31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  const bool leap = date.year % 4 == 0 && date.year != 1900;  // 2000 is one
  const int of_month = days[static_cast<std::size_t>(date.month - 1)];
  return date.day <= of_month + (leap && date.month == 2 ? 1 : 0);
}

// Source: Meeus, ch. 7, eq. 7.1; 2000-01-01 12:00 is 2451545.
double days_since_2000(const CalendarDate& date, const ClockTime& time, double utc_offset_hours) {
  const int shift = date.month <= 2 ? 1 : 0;
  const int year = date.year - shift, month = date.month + 12 * shift;
  const int century = year / 100;
  const double midnight = std::floor(365.25 * (year + 4716)) + std::floor(30.6001 * (month + 1)) +
                          date.day + (2 - century + century / 4) - 1524.5;
  return midnight - 2451545 + time.seconds / 86400.0 - utc_offset_hours / 24;
}

// ---- the sun --------------------------------------------------------------------------------

SunPosition sun_position(double days, double latitude, double longitude) {
  const double t = days / 36525;  // Julian centuries
  // The sun's true longitude, then the apparent one, with aberration and the main nutation.
  const double mean = 280.46646 + t * (36000.76983 + t * 0.0003032);
  const double anomaly = 357.52911 + t * (35999.05029 - t * 0.0001537);
  const double center = (1.914602 - t * (0.004817 + t * 0.000014)) * sin_degrees(anomaly) +
                        (0.019993 - t * 0.000101) * sin_degrees(2 * anomaly) +
                        0.000289 * sin_degrees(3 * anomaly);
  const double node = 125.04 - 1934.136 * t;
  const double nutation = -0.00478 * sin_degrees(node);
  const double apparent = mean + center - 0.00569 + nutation;
  // To right ascension and declination.
  const double obliquity = 23.4392911 - t * 0.0130042 + 0.00256 * cos_degrees(node);
  const double sine = sin_degrees(apparent);
  const double ascension = 360 * turn_of(cos_degrees(obliquity) * sine, cos_degrees(apparent));
  const double sin_declination = sin_degrees(obliquity) * sine;
  const double cos_declination = std::sqrt(1 - sin_declination * sin_declination);
  // To the horizon, by the hour angle.
  const double sidereal = 280.46061837 + 360.98564736629 * days + t * t * 0.000387933 +
                          nutation * cos_degrees(obliquity);
  const double hour = sidereal + longitude - ascension;
  const double up = sin_degrees(latitude) * sin_declination +
                    cos_degrees(latitude) * cos_declination * cos_degrees(hour);
  const double north = cos_degrees(latitude) * sin_declination -
                       sin_degrees(latitude) * cos_declination * cos_degrees(hour);
  const double east = -cos_declination * sin_degrees(hour);
  const double aside = std::sqrt(north * north + east * east);
  return {atan2_of(up, aside) * 180 / pi, 360 * turn_of(east, north)};
}

}  // namespace tia
