// How far a picture's rounds have come.
#pragma once

namespace tia {

/// Reached: how far the rounds of a picture have come.
struct Reached {
  int least = 0, most = 0;  ///< samples of a pixel
  double mean = 0;
  double noise = 0;  ///< the largest error of a pixel, as a display shows it (Convergence)
  int samples = 0;   ///< what, asked for without a budget, gives the same picture
};

}  // namespace tia
