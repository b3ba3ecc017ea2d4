// Falls: when a polynomial of the time goes from above 0 to below, as a gap does that closes.
#pragma once

#include <array>
#include <span>

namespace tia {

/// Falls: ascending times at which it happens.
struct Falls {
  static constexpr int most = 8;
  std::array<double, most> times;
  int count = 0;

  void add(double t) { times[static_cast<std::size_t>(count++)] = t; }
  const double* begin() const { return times.data(); }
  const double* end() const { return times.data() + count; }
};

/// How a gap is at the time 0: `apart`; or `touching`, 0 to rounding and not closing, so that what
/// rounding makes of it is no contact.
enum class GapStart { apart, touching };

/// When c[0] + c[1] t + c[2] t^2 + ... falls through 0 in [0, until]; and where it is at most 0 and
/// begins to fall: so two that overlap by rounding meet at the latest when they approach again, and
/// never pass through each other.
/// Domain: degree <= 8; a finite `until`, but for degrees up to 2.
/// Source: Bannerman et al., "Stable algorithm for event detection in event-driven particle
/// dynamics", Comput. Part. Mech. 1 (2014), section 2.
Falls falls_of(std::span<const double> c, double until, GapStart start);

}  // namespace tia
