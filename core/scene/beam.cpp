#include "core/scene/beam.h"

#include <algorithm>
#include <cmath>

namespace tia {

// A float ray strays from the exact one: its eye by half a float's step; its direction by a few
// steps of the terms of its sum, whose length is no less than the eye's distance from the plane.
Beam::Beam(const View& view, int x0, int y0, int x1, int y1) : origin_(view.origin) {
  if (view.orthographic() || view.has_lens() || !view.is_flat()) return;
  constexpr double step = 0x1p-23;
  const Vec3d normal = normalize(cross(view.right, view.up));
  const double terms = length(view.forward) + length(view.right) + length(view.up);
  eye_blur_ = step * length(view.origin);
  const auto corner = [&](int x, int y) {  // of the pixels, not of their centres
    const double sx = 2.0 * x / view.width - 1, sy = 1 - 2.0 * y / view.height;
    return normalize(view.forward + view.right * sx + view.up * sy);
  };
  const Vec3d corners[] = {corner(x0, y0), corner(x1, y0), corner(x1, y1), corner(x0, y1)};
  axis_ = normalize(corners[0] + corners[1] + corners[2] + corners[3]);
  double chord = 0;  // 2 sin(spread / 2), which keeps its digits where the spread is tiny
  for (const Vec3d& each : corners) chord = std::max(chord, length(each - axis_));
  chord += 8 * step * terms / std::fabs(dot(view.forward, normal));
  if (!(chord < 1)) return;  // so wide that it spares little; or NaN, of a view beyond double
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

}  // namespace tia
