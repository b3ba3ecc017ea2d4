// SunLight: the sun, and the sky that its light makes of the air.
#pragma once

#include <optional>
#include <string_view>

#include "core/input/errors.h"
#include "core/input/fields.h"
#include "core/lights/atmosphere.h"
#include "core/lights/light_sample.h"
#include "core/lights/sphere_light.h"
#include "core/lights/sun_position.h"

namespace tia {

/// SunLight: its disc lights surfaces, the dome is seen where rays leave. The path tracer sees the
/// disc, and is lit by the dome too.
/// Space/units: degrees; azimuths as in sky_direction(): 0 is -z, 90 is x.
struct SunLight {
  static constexpr std::string_view type = "sun";
  static constexpr bool endless = true;
  std::optional<double> elevation_degrees, azimuth_degrees;
  std::optional<CalendarDate> date;
  std::optional<ClockTime> time;
  std::optional<double> latitude_degrees, longitude_degrees;
  double utc_offset_hours = 0;
  double turbidity = 1.5, ground = 0.2;
  int samples = 1;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("elevation_degrees", &SunLight::elevation_degrees,
          Spec{.about = "how high the sun stands; none: 45", .min = -90, .max = 90});
    visit("azimuth_degrees", &SunLight::azimuth_degrees,
          Spec{.about = "from north, which is -z, towards east, x; none: 180",
               .min = -360,
               .max = 360});
    visit("date", &SunLight::date, Spec{.about = "the day, in place of the two angles"});
    visit("time", &SunLight::time, Spec{.about = "of that day, by the clock"});
    visit("latitude_degrees", &SunLight::latitude_degrees,
          Spec{.about = "north is positive", .min = -90, .max = 90});
    visit("longitude_degrees", &SunLight::longitude_degrees,
          Spec{.about = "east is positive", .min = -180, .max = 180});
    visit("utc_offset_hours", &SunLight::utc_offset_hours,
          Spec{.about = "how far the clock is ahead of universal time", .min = -12, .max = 14});
    visit("turbidity", &SunLight::turbidity,
          Spec{.about = "the optical depth of air and dust over that of air alone: 1.5 is clear, 6 "
                        "hazy",
               .min = 1,
               .max = 10});
    visit("ground", &SunLight::ground,
          Spec{.about = "the share of light that the ground sends back, which is seen below the "
                        "horizon",
               .min = 0,
               .max = 1});
    visit("samples", &SunLight::samples, light_samples);
  }
  /// Some of date, time, latitude and longitude, and not all; all of them and an angle; a day that
  /// its month does not have.
  void check(const Place& at, Faults& faults) const;
  bool operator==(const SunLight&) const = default;

  void move_by(const Vec3d&) {}  // it stands in the same direction everywhere
  /// Where it stands, by the angles or by date, time and place.
  SunPosition stands() const;
};

/// SunForm: a disc infinitely far away. What lies below the horizon does not shine.
struct SunForm {
  Constant wi;         ///< towards its middle, unit
  double sine_square;  ///< of the angle from the middle to the limb
  double rise;         ///< 1 - its cosine
  /// The disc's radiance over the light's colour: what a white matt surface that faces it sends
  /// back is the share of all its directions that the disc fills.
  double brightness() const { return 1 / sine_square; }
};
SunForm prepare(const SunLight& light);
/// The colour of its direct light, in the units of SunlitSky.
Vec3d tint(const SunLight& light);
SkyForm sky_of(const SunLight& light);

template <class Real>
Real strength_of(const SunForm&, const Vec3<Real>& wi) {
  return select(wi.y > Real(0), Real(1), Real(0));
}
template <class Real>
LightSample<Real> sample_li(const SunForm& light, const Vec3<Real>&) {
  const Vec3<Real> wi = lift<Real>(light.wi);
  return {wi, Real(infinity), strength_of(light, wi)};
}
/// Uniform over the solid angle. Source: as SphereForm's.
template <class Real>
LightSample<Real> sample_li(const SunForm& light, const Vec3<Real>&, const Real& u, const Real& v) {
  using std::sqrt;
  const Real height = lift<Real>(light.rise);
  const DiscPoint<Real> at = square_to_disc(u, v);
  const Real rise = (at.x * at.x + at.y * at.y) * height, aside = sqrt(height * (Real(2) - rise));
  const Vec3<Real> middle = lift<Real>(light.wi);
  const auto [x, y] = axes_around(middle);
  const Vec3<Real> wi =
      normalize(middle * (Real(1) - rise) + x * (at.x * aside) + y * (at.y * aside));
  return {wi, Real(infinity), strength_of(light, wi)};
}
/// The density of those directions by solid angle; 0 beside the disc.
template <class Real>
Real pdf_li(const SunForm& light, const Vec3<Real>&, const Vec3<Real>& wi, const Real&) {
  const Vec3<Real> middle = lift<Real>(light.wi), across = cross(wi, middle);
  const Mask<Real> here =
      dot(wi, middle) > Real(0) && dot(across, across) < lift<Real>(light.sine_square);
  return select(here, Real(0.159154943F) / lift<Real>(light.rise), Real(0));  // 1 / 2 pi
}
static_assert(EndlessForm<SunForm>);

}  // namespace tia
