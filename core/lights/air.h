// Air: what the air does with the sun's light on its way to the eye: takes some away, and scatters
// some once. On a round earth, seen from sea level.
#pragma once

#include <vector>

#include "core/math/vec3.h"

namespace tia {

/// Depths: how much of air, dust and ozone lies along a way, as metres of it as thick as where it
/// is thickest.
struct Depths {
  double air = 0, dust = 0, ozone = 0;
  Depths operator+(const Depths& b) const { return {air + b.air, dust + b.dust, ozone + b.ozone}; }
  Depths operator-(const Depths& b) const { return {air - b.air, dust - b.dust, ozone - b.ozone}; }
  Depths operator*(double s) const { return {air * s, dust * s, ozone * s}; }
};

/// Scattered: what reaches the eye from all along a way, by who has scattered it, but for the
/// factors of the angle. Space/units: 1/sr for each unit of the sun's light above the air.
struct Scattered {
  Vec3d by_air{}, by_dust{};
  Scattered operator*(double s) const { return {by_air * s, by_dust * s}; }
  Scattered operator+(const Scattered& b) const { return {by_air + b.by_air, by_dust + b.by_dust}; }
};

/// Source: Nishita, Sirai, Tadamura, Nakamae, "Display of the earth taking into account
/// atmospheric scattering" (1993). Space/units: of all light linear sRGB; 1 is that of a white matt
/// surface that faces the sun above the air, by luminance.
class Air {
 public:
  /// `turbidity`: the vertical optical depth of air and dust at 550 nm over the air's, from 1.
  Air(double sun_elevation_degrees, double turbidity);

  /// What a white matt surface that faces the sun sends back of its direct light.
  Vec3d sun() const;

  /// Node: a point on a way from the eye. Space/units: metres.
  struct Node {
    double x, y;          ///< aside and up from the earth's middle
    Depths to_eye, here;  ///< here: times the stretch of the way that it stands for
  };
  /// Of the way whose elevation has that sine. Domain: 0 <= sine <= 1.
  std::vector<Node> nodes(double sine) const;
  /// The cosine is that of the azimuth from the sun's.
  Scattered scattered(const std::vector<Node>& way, double cos_azimuth) const;
  /// With the factors of the angle: the radiance.
  Vec3d seen(const Scattered& scattered, double sine, double cos_azimuth) const;

 private:
  double dust_;  // what dust takes away at sea level, 1/m
  double sin_sun_, cos_sun_;
};

}  // namespace tia
