// BoxRay: a packet of rays, or a single ray, in the form that the test with boxes needs.
#pragma once

#include <array>

#include "core/boxes/box32.h"
#include "core/math/tolerances.h"
#include "core/math/wide.h"

namespace tia {

/// Factors on where a ray enters and leaves a box.
inline constexpr float box_shrink = 1 - tolerance::box_t, box_grow = 1 + tolerance::box_t;

/// BoxRay: a ray in the form that the slab test needs. The test never misses a box that the ray
/// meets.
/// Source: Ize, "Robust BVH Ray Traversal", JCGT 2 (2013).
template <class Real>
class BoxRay {
 public:
  /// `blur`: how far the origin may lie from the exact one, in each component.
  BoxRay(const Vec3<Real>& origin, const Vec3<Real>& direction, const Real& blur)
      : low_{origin.x + blur, origin.y + blur, origin.z + blur},
        high_{origin.x - blur, origin.y - blur, origin.z - blur},
        inverse_{away_from_zero(direction.x), away_from_zero(direction.y),
                 away_from_zero(direction.z)},
        backwards_{first_below_zero(direction.x), first_below_zero(direction.y),
                   first_below_zero(direction.z)},
        exact_(!any(blur > Real(0))) {}

  /// The same directions from another origin.
  BoxRay from(const Vec3<Real>& origin, const Real& blur) const {
    BoxRay moved = *this;
    moved.low_ = {origin.x + blur, origin.y + blur, origin.z + blur};
    moved.high_ = {origin.x - blur, origin.y - blur, origin.z - blur};
    moved.exact_ = !any(blur > Real(0));
    return moved;
  }
  /// The lanes whose rays are in the box for some t from 0 to t_max.
  [[gnu::always_inline]] Mask<Real> enters(const Box32& box, const Real& t_max) const {
    Real near(0), far = t_max;
    const auto slab = [&](float from, float to, const Real& low, const Real& high,
                          const Real& inverse) __attribute__((always_inline)) {
      const Real a = (Real(from) - low) * inverse, b = (Real(to) - high) * inverse;
      near = max_of(min_of(a, b), near);
      far = min_of(max_of(a, b), far);
    };
    slab(box.min.x, box.max.x, low_.x, high_.x, inverse_.x);
    slab(box.min.y, box.max.y, low_.y, high_.y, inverse_.y);
    slab(box.min.z, box.max.z, low_.z, high_.z, inverse_.z);
    return near * Real(box_shrink) <= far * Real(box_grow);
  }
  /// One of its rays.
  BoxRay<float> one(int i) const {
    BoxRay<float> ray;
    const auto of = [i](const Vec3<Real>& v) -> Vec3f {
      return {lane(v.x, i), lane(v.y, i), lane(v.z, i)};
    };
    ray.low_ = of(low_), ray.high_ = of(high_), ray.inverse_ = of(inverse_);
    ray.backwards_ = {ray.inverse_.x < 0, ray.inverse_.y < 0, ray.inverse_.z < 0};
    ray.exact_ = exact_;
    return ray;
  }
  /// Calls f(axis, low, high, inverse): the origin plus and minus its blur, and the direction.
  template <class F>
  void for_each_axis(F f) const {
    f(0, low_.x, high_.x, inverse_.x);
    f(1, low_.y, high_.y, inverse_.y);
    f(2, low_.z, high_.z, inverse_.z);
  }
  /// Whether the first lane's direction is negative along an axis, to choose which of two boxes to
  /// try first.
  bool backwards(int axis) const { return backwards_[static_cast<std::size_t>(axis)]; }
  /// Whether there is no blur in any lane.
  bool is_exact() const { return exact_; }

 private:
  template <class>
  friend class BoxRay;
  BoxRay() = default;

  // A component below 1e-30 becomes 1e-30, so that its inverse is finite and 0 * infinity cannot
  // occur. Within the greatest distance, some 1e9, such a ray moves 1e-21: less than rounding.
  static Real away_from_zero(const Real& d) {
    constexpr float tiny = 1e-30F;
    const Real least = select(d < Real(0), Real(-tiny), Real(tiny));
    return Real(1) / select(abs_of(d) < Real(tiny), least, d);
  }
  static bool first_below_zero(const Real& d) { return (bits(d < Real(0)) & 1U) != 0; }

  Vec3<Real> low_, high_, inverse_;
  std::array<bool, 3> backwards_;
  bool exact_;
};

}  // namespace tia
