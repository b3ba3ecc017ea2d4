// Rays and hits. Normal and colour are not in a hit: they are computed later, for the closest one.
#pragma once

#include "core/math/lanes.h"
#include "core/math/vec3.h"

namespace tia {

/// Ray: origin + t * direction, t > 0. The direction has unit length.
template <class Real>
struct Ray {
  Vec3<Real> origin, direction;

  Vec3<Real> at(Real t) const { return origin + direction * t; }
};

/// RootRay: the same ray in double, made once and shared by all shapes that it is tried on, so that
/// for every scalar roots are computed in double and rounded once, at the end.
template <class Real>
struct RootRay {
  using P = Precise<Real>;
  Vec3<P> origin, direction;
  P inverse_a;  ///< 1 / |direction|^2, off 1 by some 1e-7 where it was normalized in float

  explicit RootRay(const Ray<Real>& ray)
      : origin(widen(ray.origin)),
        direction(widen(ray.direction)),
        inverse_a(near_inverse(dot(direction, direction))) {}
  /// A ray of any length, as a transform leaves it.
  RootRay(const Vec3<P>& from, const Vec3<P>& way)
      : origin(from), direction(way), inverse_a(P(1) / dot(way, way)) {}
  /// One ray for all lanes.
  template <class Other>
  explicit RootRay(const RootRay<Other>& one)
      : origin(static_cast<Vec3<P>>(one.origin)),
        direction(static_cast<Vec3<P>>(one.direction)),
        inverse_a(one.inverse_a) {}
  RootRay<float> one(int i) const {
    RootRay<float> ray;
    ray.origin = {lane(origin.x, i), lane(origin.y, i), lane(origin.z, i)};
    ray.direction = {lane(direction.x, i), lane(direction.y, i), lane(direction.z, i)};
    ray.inverse_a = lane(inverse_a, i);
    return ray;
  }

 private:
  template <class>
  friend struct RootRay;
  RootRay() = default;

  // 1/a to within 3 (1 - a)^2; 0 where there is no direction, so that such a ray meets nothing.
  static P near_inverse(const P& a) { return a * (P(3) - (a + a)); }
};

/// Hit: the nearest crossing so far; t is infinite where there is none. `primitive` is an index
/// into the world, `element` numbers the primitive's faces or triangles, `instance` the instances
/// of repeated groups; each is kept in a lane of the scalar, exact up to 2^24.
template <class Real>
struct Hit {
  Real t = Real(infinity);
  Real primitive = Real(-1), element = Real(0), instance = Real(0);
};

}  // namespace tia
