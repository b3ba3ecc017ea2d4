// Weighted least squares for several centres at once, one in each lane.
#pragma once

#include <array>
#include <cstddef>

#include "core/film/denoise_weights.h"

namespace tia {

/// CenterFits: the normal equations of as many centres as a row of a tile has, and their solutions.
/// Sums are in double, in the order in which pixels are added.
class CenterFits {
 public:
  static constexpr std::size_t lanes = PatchDistances::centers;
  static constexpr std::size_t terms = 9;     ///< a constant, six features, and the place
  static constexpr std::size_t channels = 3;  ///< of light
  using Lanes = std::array<double, lanes>;
  using Terms = std::array<Lanes, terms>;
  using Channels = std::array<Lanes, channels>;

  /// Adds one pixel for each centre: its weight, its terms, of which the first is 1, and its light.
  void add(const Lanes& weight, const Terms& x, const Channels& y);
  /// What the terms are to be multiplied by. A term whose part that the ones before it do not tell
  /// varies by less than a thousandth of its `scale` has no say: it would tell noise.
  /// Source: Golub, Van Loan, "Matrix computations", 4.1.2: Cholesky without roots.
  std::array<Channels, terms> solved(const Terms& scale);

 private:
  std::array<std::array<Lanes, terms>, terms> products_{};  // the upper triangle
  std::array<Channels, terms> light_{};
};

}  // namespace tia
