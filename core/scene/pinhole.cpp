#include "core/scene/pinhole.h"

#include "core/math/onb.h"

namespace tia {

Camera seen_through(const Pinhole& pinhole, const Camera& frame, int width, int height) {
  const Vec3d ahead = unit(axis_of(frame));
  const Vec3d u = unit(cross(ahead, frame.up)), v = cross(u, ahead);
  const double half_width = width / 2.0, half_height = height / 2.0;
  Camera camera;
  camera.location = frame.location;
  camera.direction = ahead + u * ((half_width - pinhole.center_x) / pinhole.focal_x) +
                     v * ((pinhole.center_y - half_height) / pinhole.focal_y);
  camera.right = u * (half_width / pinhole.focal_x);
  camera.up = v * (half_height / pinhole.focal_y);
  return camera;
}

}  // namespace tia
