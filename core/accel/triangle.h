// Rays and triangles: a watertight test that reads the same for one triangle and many rays and for
// one ray and many triangles.
#pragma once

#include <array>

#include "core/math/wide.h"

namespace tia {

/// Along which axis each direction is longest, the first of equals.
template <class Real>
struct LongestAxis {
  Mask<Real> x, y;

  explicit LongestAxis(const Vec3<Real>& way) {
    const Real a = abs_of(way.x), b = abs_of(way.y), c = abs_of(way.z);
    x = a >= b && a >= c;
    y = !x && b >= c;
  }
  std::size_t of(int lane) const {
    return (bits(x) >> lane & 1) != 0 ? 0 : (bits(y) >> lane & 1) != 0 ? 1 : 2;
  }
};

/// ShearedRay: a ray in axes in which it leaves from 0 and runs along the last: each other axis is
/// sheared until it does. Of a packet, `axes` may suit some of the rays only.
template <class Real>
struct ShearedRay {
  std::array<std::size_t, 3> axes{};  ///< the two across, and the one along which it is longest
  std::array<Real, 3> origin{};       ///< in that order
  std::array<Real, 3> shear{};        ///< across / along, twice, and 1 / along

  ShearedRay() = default;
  ShearedRay(const Vec3<Real>& from, const Vec3<Real>& way, const LongestAxis<Real>& longest) {
    const auto turned = [&](const Vec3<Real>& v) -> Vec3<Real> {
      return select(longest.x, {v.y, v.z, v.x}, select(longest.y, {v.z, v.x, v.y}, v));
    };
    const Vec3<Real> o = turned(from), d = turned(way);
    origin = {o.x, o.y, o.z};
    shear = {d.x / d.z, d.y / d.z, Real(1) / d.z};
  }
  void turn_to(std::size_t along) { axes = {(along + 1) % 3, (along + 2) % 3, along}; }
  /// A ray for all lanes.
  template <class Other>
  explicit ShearedRay(const ShearedRay<Other>& one) : axes(one.axes) {
    for (std::size_t i = 0; i < 3; ++i)
      origin[i] = Real(one.origin[i]), shear[i] = Real(one.shear[i]);
  }
  ShearedRay<float> one(int i) const {
    ShearedRay<float> ray;
    ray.axes = axes;
    for (std::size_t k = 0; k < 3; ++k)
      ray.origin[k] = lane(origin[k], i), ray.shear[k] = lane(shear[k], i);
    return ray;
  }
};

template <class Real>
struct TriangleHit {
  Mask<Real> inside;
  Real t;  ///< of any sign, and of no meaning outside
};

/// Where a ray meets a triangle, of which coordinate(corner, axis) tells.
///
/// Watertight: where a corner lies across the ray comes out the same for every triangle that has
/// it, and so does the side of the ray on which the edge of two triangles lies, for rounding is
/// monotonic: it makes a difference of products nothing, but never the opposite. On an edge both
/// are hit. A triangle seen edge on is not: it has no thickness.
/// Source: Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection", JCGT 2 (2013).
template <class Real, class Coordinate>
[[gnu::always_inline]] inline TriangleHit<Real> intersect(const ShearedRay<Real>& ray,
                                                          Coordinate coordinate) {
  const auto seen = [&](std::size_t corner) __attribute__((always_inline))->Vec3<Real> {
    const Real depth = coordinate(corner, ray.axes[2]) - ray.origin[2];
    return {coordinate(corner, ray.axes[0]) - ray.origin[0] - ray.shear[0] * depth,
            coordinate(corner, ray.axes[1]) - ray.origin[1] - ray.shear[1] * depth, depth};
  };
  const Vec3<Real> a = seen(0), b = seen(1), c = seen(2);
  const Real u = c.x * b.y - c.y * b.x, v = a.x * c.y - a.y * c.x, w = b.x * a.y - b.y * a.x;
  TriangleHit<Real> hit{min_of(u, min_of(v, w)) >= Real(0) || max_of(u, max_of(v, w)) <= Real(0),
                        Real(infinity)};
  if (!any(hit.inside)) return hit;
  hit.t = (u * a.z + v * b.z + w * c.z) / (u + v + w) * ray.shear[2];
  return hit;
}

}  // namespace tia
