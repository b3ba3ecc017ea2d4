// What radio waves are measured by.
#pragma once

#include "core/math/deterministic.h"

namespace tia {

/// Metres a second, exact.
inline constexpr double speed_of_light = 299'792'458;
/// Farad a metre. Source: CODATA 2018.
inline constexpr double vacuum_permittivity = 8.8541878128e-12;

/// Wave: a frequency, and what follows of it in empty space.
struct Wave {
  static constexpr double least = 1e6, most = 3e11;  ///< Hz
  double frequency = 1e9;                            ///< Hz

  double length() const { return speed_of_light / frequency; }
  /// Radians a metre.
  double number() const { return 2 * pi * frequency / speed_of_light; }
};

}  // namespace tia
