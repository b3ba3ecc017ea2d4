// Cameras by their intrinsics, as robots' sensors are told.
#pragma once

#include "core/scene/camera.h"

namespace tia {

/// Pinhole: a camera's focal lengths, and where its axis meets the picture, from the picture's top
/// left corner. Space/units: pixels.
struct Pinhole {
  double focal_x = 1, focal_y = 1, center_x = 0, center_y = 0;
};

/// The camera where `frame` is, with its axes, that sees a picture of that size through the
/// pinhole, as a view plane at distance 1: pixel (i, j), row 0 on top, looks along
///   ((i + 1/2 - center_x) / focal_x, (center_y - j - 1/2) / focal_y, -1)
/// in the axes right, up and towards the viewer.
/// Domain: a frame that its check has passed; focal lengths above 0. What comes out may fail
/// Camera::check: far off the axis, or of a focal length that is next to nothing.
Camera seen_through(const Pinhole& pinhole, const Camera& frame, int width, int height);

}  // namespace tia
