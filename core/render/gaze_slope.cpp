#include "core/render/gaze_slope.h"

namespace tia {

GazeLimit::GazeLimit(const View& view, const Gaze& gaze, const Window& window)
    : acuity_(gaze.acuity),
      window_(window),
      frame_(view, gaze.x, gaze.y),
      fovea_(frame_, acuity_, window) {}

GazeCount GazeLimit::count(double slope) const {
  Acuity acuity = acuity_;
  acuity.slope = slope;
  return count_of(fovea_, GazeRings(frame_, acuity, fovea_, window_), slope);
}

std::optional<double> GazeLimit::slope_within(std::int64_t rays) const {
  double less = acuity_.slope, more = Acuity::most_slope;
  const auto fits = [&](double slope) { return count(slope).all() <= rays; };
  if (fits(less)) return less;
  if (!fits(more)) return std::nullopt;
  for (int i = 0; i < 30; ++i) {
    const double middle = less + (more - less) / 2;
    (fits(middle) ? more : less) = middle;
  }
  return more;
}

}  // namespace tia
