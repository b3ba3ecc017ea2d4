// Random words as numbers of the unit interval, one in each lane.
#pragma once

#include "core/math/lanes.h"
#include "core/math/rng.h"

namespace tia {

/// Each lane's multiple of 2^-24 in [0, 1).
template <class Real>
Real unit_lanes(const std::array<std::uint32_t, static_cast<std::size_t>(lanes<Real>)>& words) {
  std::array<LaneOf<Real>, static_cast<std::size_t>(lanes<Real>)> each;
  for (std::size_t i = 0; i < each.size(); ++i) each[i] = unit_float(words[i]);
  return load<Real>(each.data());
}

}  // namespace tia
