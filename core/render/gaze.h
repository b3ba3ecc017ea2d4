// Gaze: where an eye looks in a picture, and how fine a detail it can see beside that.
#pragma once

#include <cstdint>
#include <string_view>

#include "core/input/fields.h"
#include "core/math/deterministic.h"

namespace tia {

/// Acuity: the smallest angle that is seen at the eccentricity e is slope e + w0.
/// Source: Guenter, Finch, Drucker, Tan, Snyder, "Foveated 3D graphics", ACM TOG 31(6), 2012, 3:
/// slopes of 0.022 to 0.028.
struct Acuity {
  static constexpr std::string_view schema_name = "acuity";
  static constexpr double least_slope = 0.005, most_slope = 1;
  double slope = 0.022, w0_degrees = 1.0 / 60;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("slope", &Acuity::slope,
          Spec{.about = "by how much the smallest angle that is seen grows with the eccentricity",
               .min = least_slope,
               .max = most_slope});
    visit("w0_degrees", &Acuity::w0_degrees,
          Spec{.about = "the smallest angle that is seen where the eye looks",
               .unit = "degrees",
               .min = 0.001,
               .max = 90});
  }
  double w0() const { return w0_degrees * (pi / 180); }
  /// Space/units: radians.
  double width(double eccentricity) const { return slope * eccentricity + w0(); }
  bool operator==(const Acuity&) const = default;
};

/// Gaze. Space/units: x and y in pixels from the picture's upper left corner, of which pixel (i, j)
/// has the square from there on; they may lie outside of the picture.
struct Gaze {
  double x = 0, y = 0;
  Acuity acuity = {};
};

/// GazeCount: how many pixels have a ray of their own, and how many rays others are filled from.
struct GazeCount {
  std::int64_t fovea = 0, periphery = 0;
  std::int64_t all() const { return fovea + periphery; }
  bool operator==(const GazeCount&) const = default;
};

}  // namespace tia
