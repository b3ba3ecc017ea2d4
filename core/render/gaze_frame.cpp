#include "core/render/gaze_frame.h"

#include <algorithm>

#include "core/math/deterministic.h"

namespace tia {
namespace {

// Source: Kahan, "How futile are mindless assessments of roundoff", 2006: exact at any angle.
double angle_between(const Vec3d& a, const Vec3d& b) {
  return atan2_of(length(cross(a, b)), dot(a, b));
}

}  // namespace

GazeFrame::GazeFrame(const View& view, double x, double y)
    : x_(x),
      y_(y),
      width_(view.width),
      height_(view.height),
      corner_(view.forward - view.right + view.up),
      right_(view.right * (2.0 / view.width)),
      down_(view.up * (-2.0 / view.height)) {
  const Vec3d way = toward(x, y);
  to_gaze_ = length(way);
  gaze_ = way * (1 / to_gaze_);
  across_ = normalize(right_ - gaze_ * dot(right_, gaze_));
  upwards_ = cross(across_, gaze_);
  if (dot(upwards_, view.up) < 0) upwards_ = -upwards_;  // a mirrored view plane
  pixel_right_ = in_frame(right_);
  pixel_down_ = in_frame(down_);
}

double GazeFrame::eccentricity(const Vec3d& way) const { return angle_between(gaze_, way); }

double GazeFrame::height_at(double x, double top) const {
  return angle_between(toward(x, top), toward(x, top + 1));
}
double GazeFrame::size_in_centre() const { return height_at(width_ * 0.5, height_ * 0.5 - 0.5); }

// A segment is seen largest from straight before its middle, at the plane's distance.
double GazeFrame::most_size() const {
  const Vec3d normal = normalize(cross(right_, down_));
  return 2 * atan2_of(length(down_) / 2, std::fabs(dot(corner_, normal)));
}

GazeFrame::Place GazeFrame::place(double eccentricity, double turn) const {
  const auto [sine, cosine] = sincos_of(eccentricity);
  const auto [up, right] = sincos_of(turn * (2 * pi));
  const Vec3d out = across_ * right + upwards_ * up;
  return {gaze_ * cosine + out * sine, out * cosine - gaze_ * sine,
          upwards_ * right - across_ * up};
}

std::array<Vec3d, 4> planes_around(const GazeFrame& frame, const Window& window) {
  const Vec3d corners[] = {frame.toward(window.x0, window.y0), frame.toward(window.x1, window.y0),
                           frame.toward(window.x1, window.y1), frame.toward(window.x0, window.y1)};
  const Vec3d middle = corners[0] + corners[2];
  std::array<Vec3d, 4> planes;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3d normal = normalize(cross(corners[i], corners[(i + 1) % 4]));
    planes[i] = frame.in_frame(dot(normal, middle) < 0 ? -normal : normal);
  }
  return planes;
}

// Within a quarter of a turn the farthest point of a convex region is a corner.
double most_eccentricity(const GazeFrame& frame, const Window& window) {
  double most = 0;
  for (const int x : {window.x0, window.x1})
    for (const int y : {window.y0, window.y1})
      most = std::max(most, frame.eccentricity(frame.toward(x, y)));
  return most < pi / 2 ? most : pi;
}

}  // namespace tia
