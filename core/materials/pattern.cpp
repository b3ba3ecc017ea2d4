#include "core/materials/pattern.h"

#include <algorithm>

namespace tia {

Vec3d PatternSpace::point(const Vec3d& p) const {
  const Vec3d q = to_pattern.point(p);
  return {q.x / scale, q.y / scale, q.z / scale};
}

PatternSpace prepare(const Pattern& pattern) {
  PatternSpace space{pattern.transform.affine().inverse(), pattern.scale, {}};
  const Affine& to = space.to_pattern;
  const auto reach = [&](double x, double y, double z) {
    return length(Vec3d{x, y, z}) / pattern.scale;
  };
  space.reach = {reach(to.x.x, to.y.x, to.z.x), reach(to.x.y, to.y.y, to.z.y),
                 reach(to.x.z, to.y.z, to.z.z)};
  return space;
}

Ramp::Ramp(const ColorStops& colors) {
  for (const Color& color : colors) stops.push_back(rgb_of(color));
}

Vec3d Ramp::at(double share) const {
  const std::size_t last = stops.size() - 1;
  if (!(share > 0)) return stops.front();
  if (share >= 1) return stops.back();
  const double place = share * static_cast<double>(last);
  const std::size_t i = std::min(static_cast<std::size_t>(place), last - 1);
  return stops[i] + (stops[i + 1] - stops[i]) * (place - static_cast<double>(i));
}

}  // namespace tia
