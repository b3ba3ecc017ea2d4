// How a root that was isolated along a line is explained.
#pragma once

#include "core/math/roots.h"
#include "core/shapes/crossing.h"

namespace tia {

/// A bracket of real_roots in words.
inline Bracket explained(const RootBracket& bracket, int degree) {
  const std::string_view how = bracket.low == bracket.high
                                   ? "a stationary point where the polynomial is 0 to rounding"
                                   : "the polynomial is monotone between stationary points";
  return {bracket.low, bracket.high, how, degree};
}

}  // namespace tia
