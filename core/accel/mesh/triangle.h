// A watertight ray/triangle test. One template serves for many rays and one triangle, and for one
// ray and many triangles.
#pragma once

#include <array>

#include "core/math/lanes.h"

namespace tia {

/// LongestAxis: the axis of the largest component of each direction, the first of equal ones.
template <class Real>
struct LongestAxis {
  Mask<Real> x, y;

  explicit LongestAxis(const Vec3<Real>& direction) {
    const Real a = abs_of(direction.x), b = abs_of(direction.y), c = abs_of(direction.z);
    x = a >= b && a >= c;
    y = !x && b >= c;
  }
  std::size_t of(int lane) const {
    const unsigned is_x = bits(x) >> lane & 1, is_y = bits(y) >> lane & 1;
    return 2 - 2 * is_x - is_y;  // no branch, which could not be predicted
  }
};

/// ShearedRay: a ray after permuting the axes and shearing, so that it starts at 0 and runs along
/// the last axis. `axes` fits only those rays of a packet that are longest along axes[2].
template <class Real>
struct ShearedRay {
  std::array<std::size_t, 3>
      axes{};                    ///< the other two axes, then the one along which it is longest
  std::array<Real, 3> origin{};  ///< in that order
  std::array<Real, 3> shear{};   ///< across / along, twice, and -1 / along

  ShearedRay() = default;
  ShearedRay(const Vec3<Real>& from, const Vec3<Real>& direction,
             const LongestAxis<Real>& longest) {
    const auto turned = [&](const Vec3<Real>& v) -> Vec3<Real> {
      return select(longest.x, {v.y, v.z, v.x}, select(longest.y, {v.z, v.x, v.y}, v));
    };
    const Vec3<Real> o = turned(from), d = turned(direction);
    origin = {o.x, o.y, o.z};
    shear = {d.x / d.z, d.y / d.z, Real(-1) / d.z};
  }
  void turn_to(std::size_t along) {
    static constexpr std::array<std::size_t, 3> turned[] = {{1, 2, 0}, {2, 0, 1}, {0, 1, 2}};
    axes = turned[along];
  }
  /// One ray in all lanes.
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
  Real t;  ///< of any sign; meaningless where not inside
};

namespace detail {

/// Weights: the edge functions of a triangle in the sheared ray's axes, in any precision. Their
/// signs tell on which side of each edge the ray passes; depth() is where it meets the plane.
template <class P>
struct Weights {
  P u, v, w;

  Weights(const Vec3<P>& a, const Vec3<P>& b, const Vec3<P>& c)
      : u(c.x * b.y - c.y * b.x), v(a.x * c.y - a.y * c.x), w(b.x * a.y - b.y * a.x) {}
  P area() const { return u + v + w; }
  P depth(const Vec3<P>& a, const Vec3<P>& b, const Vec3<P>& c) const {
    return (u * a.z + v * b.z + w * c.z) / area();
  }
};

template <class Real>
[[gnu::always_inline]] inline Mask<Real> all_alike(const Real& u, const Real& v, const Real& w) {
  return min_of(u, min_of(v, w)) >= Real(0) || max_of(u, max_of(v, w)) <= Real(0);
}

}  // namespace detail

/// SeenTriangle: the triangle with the corners coordinate(corner, axis), seen from a ray's origin
/// in its sheared axes, with all signs turned round: a coordinate that is subtracted may stay in
/// memory, and signs do not change how numbers are rounded.
///
/// Watertight: a corner's sheared coordinates are the same for every triangle that has the corner,
/// and an edge function has the same value, up to its sign, for both triangles at the edge.
/// Rounding is monotonic, so it may make a difference of products 0, but never change its sign. On
/// an edge both triangles are hit. Where a triangle is seen so nearly edge on that rounding could
/// decide, the products are computed in double, where they are exact. One that is seen exactly edge
/// on is missed. Source: Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection", JCGT 2
/// (2013).
template <class Real>
class SeenTriangle {
 public:
  template <class Coordinate>
  [[gnu::always_inline]] SeenTriangle(const ShearedRay<Real>& ray, Coordinate coordinate)
      : a_(seen(ray, coordinate, 0)),
        b_(seen(ray, coordinate, 1)),
        c_(seen(ray, coordinate, 2)),
        weights_(a_, b_, c_) {}

  /// Whether the ray passes through it, unless its sign is doubtful().
  [[gnu::always_inline]] Mask<Real> inside() const {
    return detail::all_alike(weights_.u, weights_.v, weights_.w);
  }
  /// Where, along the ray.
  [[gnu::always_inline]] Real t(const ShearedRay<Real>& ray) const {
    return weights_.depth(a_, b_, c_) * ray.shear[2];
  }
  /// Whether float may have the wrong sign. If the area is at least 1/16 of the products,
  /// cancellation has cost at most four of 24 bits.
  [[gnu::always_inline]] Mask<Real> doubtful() const {
    const Real products = abs_of(c_.x * b_.y) + abs_of(a_.x * c_.y) + abs_of(b_.x * a_.y);
    return opposite(abs_of(weights_.area()) * Real(16) >= products);
  }
  /// The same in double, of the corners as float sees them.
  TriangleHit<Real> exact(const ShearedRay<Real>& ray) const {
    const auto a = widen(a_), b = widen(b_), c = widen(c_);
    const detail::Weights<Precise<Real>> weights(a, b, c);
    const auto narrowed = [](const Precise<Real>& x) { return narrow<Real>(x); };
    return {detail::all_alike(narrowed(weights.u), narrowed(weights.v), narrowed(weights.w)),
            narrow<Real>(weights.depth(a, b, c)) * ray.shear[2]};
  }

 private:
  template <class Coordinate>
  [[gnu::always_inline]] static Vec3<Real> seen(const ShearedRay<Real>& ray, Coordinate coordinate,
                                                std::size_t corner) {
    const Real depth = ray.origin[2] - coordinate(corner, ray.axes[2]);
    return {ray.origin[0] - coordinate(corner, ray.axes[0]) - ray.shear[0] * depth,
            ray.origin[1] - coordinate(corner, ray.axes[1]) - ray.shear[1] * depth, depth};
  }

  Vec3<Real> a_, b_, c_;
  detail::Weights<Real> weights_;
};

/// Repeats the test in double for the lanes in which float may have the wrong sign. Apart, for it
/// is seldom asked for and needs all registers.
template <class Real, class Coordinate>
[[gnu::noinline]] TriangleHit<Real> settled(const ShearedRay<Real>& ray, Coordinate coordinate,
                                            const Mask<Real>& doubtful,
                                            const TriangleHit<Real>& hit) {
  const TriangleHit<Real> exact = SeenTriangle<Real>(ray, coordinate).exact(ray);
  return {(hit.inside && !doubtful) || (exact.inside && doubtful),
          select(doubtful, exact.t, hit.t)};
}

/// Where a ray meets a triangle.
template <class Real, class Coordinate>
[[gnu::always_inline]] inline TriangleHit<Real> intersect(const ShearedRay<Real>& ray,
                                                          Coordinate coordinate) {
  const SeenTriangle<Real> triangle(ray, coordinate);
  TriangleHit<Real> hit{triangle.inside(), Real(infinity)};
  if (!any(hit.inside)) return hit;
  hit.t = triangle.t(ray);
  if constexpr (!std::is_same_v<Real, double>) {
    const Mask<Real> doubtful = hit.inside && triangle.doubtful();
    if (any(doubtful)) hit = settled(ray, coordinate, doubtful, hit);
  }
  return hit;
}

}  // namespace tia
