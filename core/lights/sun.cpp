#include "core/lights/sun.h"

#include <array>
#include <string>

#include "core/input/codec.h"

namespace tia {
namespace {

Weather weather_of(const SunLight& light) {
  return {light.stands().elevation, light.turbidity, light.ground};
}

void add_conflict(const Place& at, const char* field, const Value& got, Faults& faults) {
  faults.add({FaultKind::conflict, at.at(field).pointer(), got,
              "either elevation_degrees and azimuth_degrees or date, time, latitude_degrees and "
              "longitude_degrees"});
}

}  // namespace

void SunLight::check(const Place& at, Faults& faults) const {
  const std::array given{std::pair{"date", date.has_value()}, std::pair{"time", time.has_value()},
                         std::pair{"latitude_degrees", latitude_degrees.has_value()},
                         std::pair{"longitude_degrees", longitude_degrees.has_value()}};
  const auto is_given = [](const auto& field) { return field.second; };
  if (std::ranges::none_of(given, is_given)) return;
  for (const auto& [field, is_there] : given)
    if (!is_there)
      faults.add({FaultKind::missing, at.at(field).pointer(), std::nullopt,
                  "date, time, latitude_degrees and longitude_degrees together"});
  if (elevation_degrees) add_conflict(at, "elevation_degrees", Value(*elevation_degrees), faults);
  if (azimuth_degrees) add_conflict(at, "azimuth_degrees", Value(*azimuth_degrees), faults);
  if (date && !exists(*date))
    faults.add({FaultKind::out_of_range, at.at("date").pointer(), write_value(*date),
                "a day that its month has"});
}

SunPosition SunLight::stands() const {
  if (!date) return {elevation_degrees.value_or(45), azimuth_degrees.value_or(180)};
  return sun_position(days_since_2000(*date, *time, utc_offset_hours), *latitude_degrees,
                      *longitude_degrees);
}

SunForm prepare(const SunLight& light) {
  const SunPosition at = light.stands();
  const double sine = sin_degrees(sun_radius_degrees), square = sine * sine;
  return {unit(sky_direction(at.azimuth / 360, sin_degrees(at.elevation))), square,
          square / (1 + cos_degrees(sun_radius_degrees))};
}

Vec3d tint(const SunLight& light) { return sunlit_sky(weather_of(light))->sun; }

SkyForm sky_of(const SunLight& light) {
  return {sunlit_sky(weather_of(light))->dome, light.stands().azimuth / 360};
}

}  // namespace tia
