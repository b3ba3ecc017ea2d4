#include "core/render/gaze_fovea.h"

#include <algorithm>

namespace tia {
namespace {

/// Span: first and behind the last of some rows, or columns.
struct Span {
  int from, to;
};
// Those of from .. to - 1 whose planes through the eye are within the angle of the gaze.
template <class Normal>
Span near_gaze(int from, int to, double angle, const Normal& normal_of) {
  Span near{to, from};
  const double sine = angle < pi / 2 ? sin_of(angle) : 1;
  for (int i = from; i < to; ++i) {
    if (std::fabs(normal_of(i).z) > sine) continue;
    near.from = std::min(near.from, i);
    near.to = i + 1;
  }
  if (near.from >= near.to) near = {from, from};
  return near;
}

}  // namespace

double first_ring(const GazeFrame& frame, const Acuity& acuity) {
  return std::max(0.0, (frame.size_in_centre() - acuity.w0()) / acuity.slope);
}

Window around_gaze(const GazeFrame& frame, const Acuity& acuity, const Window& window) {
  // A little more, for what is rounded.
  const double most = std::max(frame.most_size(), frame.size_in_centre()) * 1.001;
  const double angle = std::max(0.0, (most - acuity.w0()) / acuity.slope);
  const auto normal = [&](const Vec3d& a, const Vec3d& b) {
    return frame.in_frame(normalize(cross(a, b)));
  };
  const Span rows = near_gaze(window.y0, window.y1, angle, [&](int y) {
    return normal(frame.toward(window.x0, y + 0.5), frame.toward(window.x1, y + 0.5));
  });
  const Span columns = near_gaze(window.x0, window.x1, angle, [&](int x) {
    return normal(frame.toward(x + 0.5, window.y0), frame.toward(x + 0.5, window.y1));
  });
  return {columns.from, rows.from, columns.to, rows.to};
}

double last_slope_of(const GazeFrame& frame, double w0, int x, int y) {
  const double spare = frame.size_of_pixel(x, y) - w0;
  const double e = frame.eccentricity(frame.toward(x + 0.5, y + 0.5));
  if (spare < 0) return -1;
  return spare < e * Acuity::most_slope ? spare / e : Acuity::most_slope;
}

GazeFovea::GazeFovea(const GazeFrame& frame, const Acuity& acuity, const Window& window)
    : box_(around_gaze(frame, acuity, window)) {
  pixels_.reserve(static_cast<std::size_t>(box_.width()) * static_cast<std::size_t>(box_.height()));
  for (int y = box_.y0; y < box_.y1; ++y)
    for (int x = box_.x0; x < box_.x1; ++x)
      pixels_.push_back({frame.polar(static_cast<float>(x + 0.5 - frame.x()),
                                     static_cast<float>(y + 0.5 - frame.y())),
                         last_slope_of(frame, acuity.w0(), x, y)});
}

std::int64_t GazeFovea::count(double slope) const {
  return std::ranges::count_if(pixels_, [&](auto& each) { return is_of_fovea(each, slope); });
}

}  // namespace tia
