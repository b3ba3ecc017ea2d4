#include "core/scene/still_framing.h"

#include <algorithm>
#include <cmath>

#include "core/math/deterministic.h"

namespace tia {
namespace {

// The share of the picture, from its centre to its side, that the points fill.
constexpr double filled = 0.9;
// How near the eye may come to them, as a share of their ball's radius.
constexpr double least_distance = 1e-3;

// f(point, radius) for all.
template <class F>
void each_point(const StillPoints& points, F f) {
  for (const Vec3d& p : points.corners) f(p, 0.0);
  for (const Vec3d& p : points.balls) f(p, points.ball_radius);
}

Aabb box_around(const StillPoints& points) {
  Aabb box;
  each_point(points, [&](const Vec3d& p, double r) {
    const Vec3d reach{r, r, r};
    box = around(box, Aabb{p - reach, p + reach});
  });
  return box;
}

// ---- the frame ----------------------------------------------------------------------------------

/// Reach: how far points go in a camera's axes from a centre, seen under slopes of the frame's
/// sides across and along.
struct Reach {
  double right = -Aabb::far, left = -Aabb::far, up = -Aabb::far, down = -Aabb::far;
  double nearest = Aabb::far;  // along the view

  Reach(const StillPoints& points, const StillBall& ball, const Basis& axes, double across,
        double along) {
    const double wide = std::sqrt(1 + across * across), high = std::sqrt(1 + along * along);
    each_point(points, [&](const Vec3d& point, double r) {
      const Vec3d p = point - ball.center;
      const double x = dot(axes.u, p), y = dot(axes.v, p), z = -dot(axes.w, p);
      right = std::max(right, x - across * z + wide * r);
      left = std::max(left, -x - across * z + wide * r);
      up = std::max(up, y - along * z + high * r);
      down = std::max(down, -y - along * z + high * r);
      nearest = std::min(nearest, z - r);
    });
  }
  double across() const { return std::max(right, left); }
  double along() const { return std::max(up, down); }
  // The eye at that place along the view, from the centre.
  Vec3d eye(const Basis& axes, double z) const {
    return axes.u * ((right - left) / 2) + axes.v * ((up - down) / 2) - axes.w * z;
  }
};

Camera looking(const Basis& axes, const Vec3d& eye) {
  Camera camera;
  camera.location = eye;
  camera.direction = axes.w * -1.0;
  camera.up = axes.v;
  return camera;
}

double zoomed_fov(const StillFrame& frame) {
  if (frame.zoom == 1) return frame.fov_degrees;
  return atan_of(tan_of(frame.fov_degrees * (pi / 360)) / frame.zoom) * (360 / pi);
}

Camera framed_by_angle(const StillPoints& points, const StillFrame& frame, const StillBall& ball) {
  const double side = tan_of(frame.fov_degrees * (pi / 360));
  const double along = filled * side, across = along * frame.aspect;
  const Reach reach(points, ball, frame.axes, across, along);
  const double z =
      std::min({-(reach.right + reach.left) / (2 * across), -(reach.up + reach.down) / (2 * along),
                reach.nearest - least_distance * ball.radius});
  Camera camera = looking(frame.axes, ball.center + reach.eye(frame.axes, z));
  camera.fov_degrees = zoomed_fov(frame);
  return camera;
}

// How far before the centre an eye has to be that looks at it.
double distance_for(const StillPoints& points, const StillFrame& frame, const StillBall& ball) {
  const double along = filled * tan_of(frame.fov_degrees * (pi / 360));
  const double across = along * frame.aspect;
  const Reach reach(points, ball, frame.axes, across, along);
  return std::max({reach.across() / across, reach.along() / along,
                   least_distance * ball.radius - reach.nearest});
}

// Parallel rays: the eye's plane lies a radius before all.
Camera framed_parallel(const StillPoints& points, const StillFrame& frame, const StillBall& ball) {
  const Reach reach(points, ball, frame.axes, 0, 0);
  const double height = std::max({(reach.right + reach.left) / frame.aspect, reach.up + reach.down,
                                  least_distance * ball.radius});
  Camera camera =
      looking(frame.axes, ball.center + reach.eye(frame.axes, reach.nearest - ball.radius));
  camera.projection = Projection::orthographic;
  camera.height = height / (filled * frame.zoom);
  return camera;
}

}  // namespace

StillBall ball_around(const StillPoints& points) {
  StillBall ball{box_around(points).center()};
  each_point(points, [&](const Vec3d& p, double r) {
    ball.radius = std::max(ball.radius, length(p - ball.center) + r);
  });
  if (!(ball.radius > 0)) ball.radius = 1;
  return ball;
}

double lowest_of(const StillPoints& points) { return box_around(points).min.y; }

Vec3d orbit_direction(double azimuth_degrees, double elevation_degrees) {
  const double level = cos_degrees(elevation_degrees);
  return {sin_degrees(azimuth_degrees) * level, sin_degrees(elevation_degrees),
          cos_degrees(azimuth_degrees) * level};
}

Basis orbit_basis(double azimuth_degrees, double elevation_degrees) {
  const double sine = sin_degrees(azimuth_degrees), cosine = cos_degrees(azimuth_degrees);
  const double rise = sin_degrees(elevation_degrees), level = cos_degrees(elevation_degrees);
  return {{cosine, 0, -sine},
          {-rise * sine, level, -rise * cosine},
          {level * sine, rise, level * cosine}};
}

Camera framed(const StillPoints& points, const StillFrame& frame) {
  const StillBall ball = ball_around(points);
  return frame.fov_degrees == 0 ? framed_parallel(points, frame, ball)
                                : framed_by_angle(points, frame, ball);
}

std::vector<Camera> framed_alike(const StillPoints& points, const std::vector<Basis>& axes,
                                 const StillFrame& frame) {
  const StillBall ball = ball_around(points);
  const bool parallel = frame.fov_degrees == 0;
  double distance = 0, height = least_distance * ball.radius;
  for (const Basis& each : axes) {
    const StillFrame own{each, frame.fov_degrees, frame.zoom, frame.aspect};
    if (!parallel) {
      distance = std::max(distance, distance_for(points, own, ball));
      continue;
    }
    const Reach reach(points, ball, each, 0, 0);
    height = std::max({height, 2 * reach.across() / frame.aspect, 2 * reach.along()});
    distance = std::max(distance, ball.radius - reach.nearest);
  }
  std::vector<Camera> cameras;
  for (const Basis& each : axes) {
    Camera& camera = cameras.emplace_back(looking(each, ball.center + each.w * distance));
    if (parallel) {
      camera.projection = Projection::orthographic;
      camera.height = height / (filled * frame.zoom);
    } else {
      camera.fov_degrees = zoomed_fov(frame);
    }
  }
  return cameras;
}

}  // namespace tia
