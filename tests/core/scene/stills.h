// What tests of stills share: points to be framed, and what of them a camera sees.
#pragma once

#include <gtest/gtest.h>

#include "core/scene/still_framing.h"
#include "tests/core/support.h"

namespace tia::test {

/// A cloud of points within a box of random sides about a random place.
inline StillPoints cloud(Random& random, int count) {
  const Vec3d middle = random.point(20);
  const double x = random.in(0.2, 4), y = random.in(0.2, 4), z = random.in(0.2, 4);
  StillPoints points;
  for (int i = 0; i < count; ++i) {
    const Vec3d p = random.point(1);
    points.corners.push_back(middle + Vec3d{p.x * x, p.y * y, p.z * z});
  }
  return points;
}

/// A frame with a random orbit and aspect; parallel where fov_degrees is 0.
inline StillFrame random_frame(Random& random, double fov_degrees) {
  const double azimuth = random.in(-360, 360), elevation = random.in(-90, 90);
  return {orbit_basis(azimuth, elevation), fov_degrees, 1, random.in(0.4, 2.5)};
}

/// SeenBox: the sides of the picture's rectangle, within [-1, 1] both ways, that points are seen
/// in.
struct SeenBox {
  double left = 1e300, right = -1e300, down = 1e300, up = -1e300;
  double across() const { return std::max(-left, right); }
  double along() const { return std::max(-down, up); }
};
/// By the definition of a camera's picture alone.
inline SeenBox seen_box(const StillPoints& points, const Camera& camera, double aspect) {
  const Vec3d forward = normalize(*camera.direction);
  const Vec3d right = normalize(cross(forward, camera.up)), up = cross(right, forward);
  const bool parallel = camera.projection == Projection::orthographic;
  SeenBox box;
  for (const Vec3d& p : points.corners) {
    const Vec3d way = p - camera.location;
    const double high =
        parallel ? *camera.height / 2 : dot(way, forward) * std::tan(camera.fov_degrees * pi / 360);
    const double x = dot(way, right) / (high * aspect), y = dot(way, up) / high;
    EXPECT_GT(dot(way, forward), 0);
    box.left = std::min(box.left, x), box.right = std::max(box.right, x);
    box.down = std::min(box.down, y), box.up = std::max(box.up, y);
  }
  return box;
}

}  // namespace tia::test
