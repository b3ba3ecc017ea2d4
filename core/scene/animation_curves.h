// Curves between two keys of a track: numbers in, numbers out.
#pragma once

#include <optional>
#include <vector>

#include "core/scene/animation.h"

namespace tia {

using TrackNumbers = std::vector<double>;

/// TrackKnot: a key's numbers and its time.
struct TrackKnot {
  double time = 0;
  TrackNumbers value;
};

/// TrackSpan: where a time is between two keys, and the keys around these, where there are any.
struct TrackSpan {
  TrackKnot from, to;
  std::optional<TrackKnot> before, after;
  double share = 0;  ///< of the way from `from` to `to`, eased
};

/// The share of the way after an ease: cubic.
double eased(double share, Ease ease);

TrackNumbers linear_between(const TrackSpan& span);

/// The cubic with those tangents, in units a second.
TrackNumbers hermite_between(const TrackSpan& span, const TrackNumbers& leaving,
                             const TrackNumbers& arriving);

/// Through points: no cusps, no loops between two keys; how fast it goes is each span's own.
/// Source: Yuksel, Schaefer, Keyser, "Parameterization and applications of Catmull-Rom curves"
/// (2011), with alpha 1/2. Beyond the ends the curve goes on by reflection.
TrackNumbers catmull_rom_between(const TrackSpan& span);

/// Each number by itself: where keys ascend or descend, so does the curve, and it leaves the range
/// of no two keys. Source: Fritsch, Carlson, "Monotone piecewise cubic interpolation" (1980):
/// slopes within the square [0, 3] x [0, 3] of its section 4.
TrackNumbers monotone_between(const TrackSpan& span);

/// Domain: four numbers each.
TrackNumbers slerp_between(const TrackSpan& span);

}  // namespace tia
