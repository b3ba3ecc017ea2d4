#include "core/scene/camera.h"

#include <algorithm>

#include "core/input/codec.h"
#include "core/math/deterministic.h"

namespace tia {
namespace {

Vec3d axis(const Camera& camera) {
  if (camera.look_at) return *camera.look_at - camera.location;
  return camera.direction.value_or(Vec3d{0, 0, -1});
}

// |a x b| as a share of |a| |b|: 0 where the two are parallel or one is zero.
double sine_between(const Vec3d& a, const Vec3d& b) {
  const double lengths = length(a) * length(b);
  return lengths > 0 ? length(cross(a, b)) / lengths : 0;
}

}  // namespace

void Camera::check(const Place& at, Faults& faults) const {
  constexpr double parallel = 1e-9, widest = 1e9;
  const std::size_t before = faults.list().size();
  const auto fault = [&](FaultKind kind, const char* field, const Value& got, const char* allowed) {
    faults.add({kind, at.at(field).pointer(), got, allowed});
  };
  if (look_at && direction)
    fault(FaultKind::conflict, "direction", write_value(*direction), "look_at or direction");
  if (right && look_at)
    fault(FaultKind::conflict, "look_at", write_value(*look_at),
          "right goes with direction and up (the view plane)");
  if (right && fov_degrees != Camera{}.fov_degrees)
    fault(FaultKind::conflict, "fov_degrees", fov_degrees,
          "right goes without fov_degrees: the view plane's size is the angle");
  if (faults.list().size() != before) return;

  const Vec3d view = axis(*this);
  const char* const axis_field = look_at ? "look_at" : "direction";
  if (length(view) == 0)
    fault(FaultKind::out_of_range, axis_field, write_value(look_at ? *look_at : view),
          look_at ? "a point other than location" : "a direction of some length");
  else if (sine_between(view, up) < parallel)
    fault(FaultKind::out_of_range, "up", write_value(up), "not zero, not parallel to the view");
  else if (right &&
           (length(*right) == 0 || std::fabs(dot(view, cross(*right, up))) <
                                       parallel * length(view) * length(*right) * length(up)))
    fault(FaultKind::out_of_range, "right", write_value(*right),
          "a view plane of some size that the eye does not lie in");
  else if (right && std::max(length(*right), length(up)) > widest * length(view))
    fault(FaultKind::out_of_range, "direction", write_value(view),
          "at least 1e-9 of the view plane's size: so far from the eye it is");
}

// A float ray strays from the exact one: its eye by half a float's step; its direction by a few
// steps of the terms of its sum, whose length is no less than the eye's distance from the plane.
Beam::Beam(const View& view, int x0, int y0, int x1, int y1) : origin_(view.origin) {
  constexpr double step = 0x1p-23;
  const Vec3d normal = normalize(cross(view.right, view.up));
  const double terms = length(view.forward) + length(view.right) + length(view.up);
  eye_blur_ = step * length(view.origin);
  const auto corner = [&](int x, int y) {  // of the pixels, not their centres: a margin of half one
    const double sx = 2.0 * x / view.width - 1, sy = 1 - 2.0 * y / view.height;
    return normalize(view.forward + view.right * sx + view.up * sy);
  };
  const Vec3d corners[] = {corner(x0, y0), corner(x1, y0), corner(x1, y1), corner(x0, y1)};
  axis_ = normalize(corners[0] + corners[1] + corners[2] + corners[3]);
  double chord = 0;  // 2 sin(spread / 2), which keeps its digits where the spread is tiny
  for (const Vec3d& each : corners) chord = std::max(chord, length(each - axis_));
  chord += 8 * step * terms / std::fabs(dot(view.forward, normal));
  cos_spread_ = 1 - chord * chord / 2;
  sin_spread_ = chord * std::sqrt(std::max(0.0, 1 - chord * chord / 4));
}

// The distance from the cone of a centre that lies beside it is aside * cos - depth * sin; where
// the cone's nearest point is its apex, the eye, only a ball around the eye can meet it.
bool Beam::may_meet(const Vec3d& center, double radius) const {
  constexpr double slack = 1e-9;  // far beyond double's rounding
  const Vec3d to_center = center - origin_;
  const double reach = radius + eye_blur_ + slack * length(to_center);
  if (length(to_center) <= reach || cos_spread_ <= 0) return true;
  const double depth = dot(axis_, to_center);
  const double aside = length(to_center - axis_ * depth);
  if (depth * cos_spread_ + aside * sin_spread_ < 0) return false;
  return aside * cos_spread_ - depth * sin_spread_ <= reach;
}

View view_of(const Camera& camera, int width, int height) {
  const Vec3d forward = axis(camera);
  if (camera.right) {  // at distance 1, lest a plane of 1e-30 vanish from float
    const double near = 1 / length(forward);
    return {camera.location, forward * near, *camera.right * near, camera.up * near, width, height};
  }
  const Vec3d w = normalize(forward);
  const Vec3d u = normalize(cross(w, camera.up));
  const Vec3d v = cross(u, w);
  const double half_height = tan_of(camera.fov_degrees / 2 * (pi / 180));
  const double half_width = half_height * static_cast<double>(width) / static_cast<double>(height);
  return {camera.location, w, u * half_width, v * half_height, width, height};
}

}  // namespace tia
