// Decibels of powers.
#pragma once

#include "core/math/deterministic.h"
#include "core/math/powers.h"

namespace tia {

inline constexpr double natural_log_of_10 = 2.302585092994045684;

/// Domain: power >= 0. Returns: -infinity of 0.
inline double decibels_of(double power) { return log_of(power) * (10 / natural_log_of_10); }
inline double power_of_decibels(double decibels) {
  return exp_of(decibels * (natural_log_of_10 / 10));
}

}  // namespace tia
