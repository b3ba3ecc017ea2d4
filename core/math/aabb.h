// Axis-aligned boxes, possibly infinite, possibly empty.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/math/vec3.h"

namespace tia {

/// Aabb: all points with min <= p <= max. A default one is empty.
struct Aabb {
  static constexpr double far = std::numeric_limits<double>::infinity();
  Vec3d min{far, far, far}, max{-far, -far, -far};

  static Aabb everything() { return {{-far, -far, -far}, {far, far, far}}; }

  bool empty() const { return !(min.x <= max.x && min.y <= max.y && min.z <= max.z); }
  /// Whether it has finite corners. Domain: not empty.
  bool bounded() const {
    const Vec3d size = max - min;
    return std::isfinite(size.x) && std::isfinite(size.y) && std::isfinite(size.z);
  }
  Vec3d center() const { return (min + max) * 0.5; }
  Vec3d size() const { return max - min; }
  /// Half the surface. Domain: not empty.
  double half_area() const {
    const Vec3d s = size();
    return s.x * s.y + s.y * s.z + s.z * s.x;
  }
  bool operator==(const Aabb&) const = default;
};

inline Vec3d lower(const Vec3d& a, const Vec3d& b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}
inline Vec3d upper(const Vec3d& a, const Vec3d& b) {
  return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

/// The smallest box around both.
inline Aabb around(const Aabb& a, const Aabb& b) {
  return {lower(a.min, b.min), upper(a.max, b.max)};
}
inline Aabb around(const Aabb& a, const Vec3d& p) { return {lower(a.min, p), upper(a.max, p)}; }
/// What both hold.
inline Aabb common(const Aabb& a, const Aabb& b) {
  return {upper(a.min, b.min), lower(a.max, b.max)};
}

}  // namespace tia
