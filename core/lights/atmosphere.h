// The light of the sun and of the sky around it, through the air.
#pragma once

#include <memory>

#include "core/lights/sky_map.h"

namespace tia {

/// The angle from the sun's middle to its limb. Space/units: degrees.
inline constexpr double sun_radius_degrees = 0.533 / 2;

struct Weather {
  double sun_elevation_degrees = 45;
  double turbidity = 1.5;  ///< the vertical optical depth of air and dust at 550 nm over the air's
  double ground = 0.2;     ///< the albedo of what lies below the horizon
  bool operator==(const Weather&) const = default;
};

/// SunlitSky. Space/units: linear sRGB; 1 is the radiance of a white matt surface that faces the
/// sun above the air, by luminance.
struct SunlitSky {
  Vec3d sun;  ///< what a white matt surface that faces the sun sends back of its direct light
  std::shared_ptr<const SkyMap> dome;  ///< the sun stands above the middle column
};

/// Light that air, dust and ozone take away and that air and dust scatter once, on a round earth
/// seen from sea level; below the horizon the ground, matt and grey, by the light of sun and dome.
/// Source: Nishita, Sirai, Tadamura, Nakamae, "Display of the earth taking into account
/// atmospheric scattering" (1993); where the numbers are from stands beside them.
SunlitSky make_sunlit_sky(const Weather& weather);
/// The same; the last ones made are kept, for whoever asks again. Threads may ask at once.
std::shared_ptr<const SunlitSky> sunlit_sky(const Weather& weather);

}  // namespace tia
