// How many rays a picture for a gaze takes, and which slope of the acuity keeps to so many.
#pragma once

#include <optional>

#include "core/render/gaze_rings.h"

namespace tia {

/// GazeLimit: a window's rays by the slope of the acuity, which is at least the gaze's own.
class GazeLimit {
 public:
  GazeLimit(const View& view, const Gaze& gaze, const Window& window);

  /// Those of one ray each, exactly.
  GazeCount count(double slope) const;
  /// The smallest slope, to 30 halvings, with at most so many rays; none where even the greatest
  /// slope has more.
  std::optional<double> slope_within(std::int64_t rays) const;

 private:
  Acuity acuity_;
  Window window_;
  GazeFrame frame_;
  GazeFovea fovea_;
};

}  // namespace tia
