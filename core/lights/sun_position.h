// Where the sun stands, by date, time and place.
#pragma once

#include <optional>
#include <string>

#include "core/input/codec.h"

namespace tia {

/// CalendarDate: of the Gregorian calendar, 1900-01-01 to 2099-12-31. In JSON "YYYY-MM-DD".
struct CalendarDate {
  int year = 2000, month = 1, day = 1;
  bool operator==(const CalendarDate&) const = default;
};
/// ClockTime: in JSON "HH:MM", or "HH:MM:SS".
struct ClockTime {
  int seconds = 0;  ///< since midnight
  bool operator==(const ClockTime&) const = default;
};

/// Errors: `wrong_type` where the text is no such date or time, or the value no text.
template <>
struct Codec<CalendarDate> {
  static void read(const Value& v, const Place& at, const Spec&, Faults& faults, CalendarDate& out);
  static Value write(const CalendarDate& v);
  static Value schema(const Spec&);
  static std::string allowed(const Spec&);
};
template <>
struct Codec<ClockTime> {
  static void read(const Value& v, const Place& at, const Spec&, Faults& faults, ClockTime& out);
  static Value write(const ClockTime& v);
  static Value schema(const Spec&);
  static std::string allowed(const Spec&);
};

/// Whether the month has that day.
bool exists(const CalendarDate& date);

/// The day and its share, counted from 2000-01-01 12:00 universal time.
double days_since_2000(const CalendarDate& date, const ClockTime& time, double utc_offset_hours);

/// SunPosition. Space/units: degrees; the azimuth from north towards east, 0 .. 360.
struct SunPosition {
  double elevation, azimuth;
};
/// Of the sun's middle, as it would stand without refraction. Within 0.01 degrees, 1900 to 2099.
/// Space/units: degrees, north and east positive.
/// Source: Meeus, "Astronomical algorithms", 2nd ed. (1998), ch. 25 (low accuracy), 12 and 13, as
/// NOAA's solar calculator has it.
SunPosition sun_position(double days, double latitude, double longitude);

}  // namespace tia
