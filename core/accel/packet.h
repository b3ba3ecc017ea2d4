// A ray, or a register's lanes of them, in the forms that boxes and surfaces are tried with.
#pragma once

#include <array>
#include <cstdint>

#include "core/math/octet.h"
#include "core/math/ray.h"
#include "core/math/transform.h"
#include "core/shapes/crossing.h"

namespace tia {

/// Box32: an Aabb rounded outwards to float and a little beyond, so that it holds all that the
/// exact one holds, its faces included.
struct Box32 {
  Vec3f min, max;
};
Box32 rounded_outwards(const Aabb& box);

/// Far beyond the three roundings of a slab's t, and beyond the one of a hit's t_max.
inline constexpr float box_shrink = 1 - 0x1p-20F, box_grow = 1 + 0x1p-20F;

/// BoxRay: the ray as the slabs of boxes need it. A test never misses a box that the ray meets.
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
                   first_below_zero(direction.z)} {}

  /// The same from elsewhere.
  BoxRay from(const Vec3<Real>& origin, const Real& blur) const {
    BoxRay moved = *this;
    moved.low_ = {origin.x + blur, origin.y + blur, origin.z + blur};
    moved.high_ = {origin.x - blur, origin.y - blur, origin.z - blur};
    return moved;
  }
  /// The lanes that are in the box somewhere from 0 to t_max.
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
    return ray;
  }
  /// Calls f(axis, low, high, inverse): the origin plus and minus its blur, and the direction.
  template <class F>
  void for_each_axis(F f) const {
    f(0, low_.x, high_.x, inverse_.x);
    f(1, low_.y, high_.y, inverse_.y);
    f(2, low_.z, high_.z, inverse_.z);
  }
  /// Whether the first lane runs against an axis: which of two boxes to try first.
  bool backwards(int axis) const { return backwards_[static_cast<std::size_t>(axis)]; }

 private:
  template <class>
  friend class BoxRay;
  BoxRay() = default;

  // A direction of 0 becomes one that is parallel enough, so that no 0 * infinity arises.
  static Real away_from_zero(const Real& d) {
    constexpr float tiny = 1e-30F;
    const Real least = select(d < Real(0), Real(-tiny), Real(tiny));
    return Real(1) / select(abs_of(d) < Real(tiny), least, d);
  }
  static bool first_below_zero(const Real& d) { return (bits(d < Real(0)) & 1U) != 0; }

  Vec3<Real> low_, high_, inverse_;
  std::array<bool, 3> backwards_;
};

/// Lines: the lanes' rays in double, one by one.
template <class Real>
class Lines {
 public:
  explicit Lines(const RootRay<Real>& ray) {
    const Precise<Real>* parts[] = {&ray.origin.x,    &ray.origin.y,    &ray.origin.z,
                                    &ray.direction.x, &ray.direction.y, &ray.direction.z};
    for (std::size_t i = 0; i < 6; ++i) store(*parts[i], parts_[i].data());
  }
  Line operator[](std::size_t lane) const {
    return {{parts_[0][lane], parts_[1][lane], parts_[2][lane]},
            {parts_[3][lane], parts_[4][lane], parts_[5][lane]}};
  }
  /// Eight of them, from a lane on.
  Ray<Octet> eight(std::size_t lane) const {
    const auto of = [&](std::size_t i) { return Octet::load_unaligned(&parts_[i][lane]); };
    return {{of(0), of(1), of(2)}, {of(3), of(4), of(5)}};
  }

 private:
  std::array<std::array<double, static_cast<std::size_t>(lanes<Real>)>, 6> parts_;
};

/// Packet: rays in one space of the world. Space/units: t is that of the world's rays in every
/// space, for directions are transformed with it.
template <class Real>
class Packet {
 public:
  using P = Precise<Real>;

  explicit Packet(const Ray<Real>& ray)
      : root(ray), box(ray.origin, ray.direction, Real(0)), unit_length(true) {}

  Packet<float> one(int i) const { return {root.one(i), box.one(i), copy, unit_length}; }
  /// The same rays in the space that `map` leads to.
  Packet seen_through(const Affine& map) const {
    return {map.point(root.origin), map.vector(root.direction), copy};
  }
  /// The same rays seen from a copy of the space that stands at `offset`.
  Packet inside_copy(const Vec3d& offset, int number) const {
    Packet inside(root, box, number, unit_length);
    inside.root.origin = root.origin - static_cast<Vec3<P>>(offset);
    const Vec3<Real> origin = narrowed(inside.root.origin);
    inside.box = box.from(origin, blur_of(origin));
    return inside;
  }

  RootRay<Real> root;
  BoxRay<Real> box;
  int copy = 0;              ///< which copy of repeated groups the rays are in
  bool unit_length = false;  ///< whether directions are unit, but for float's rounding

 private:
  template <class>
  friend class Packet;
  Packet(const Vec3<P>& origin, const Vec3<P>& direction, int number)
      : root(origin, direction),
        box(narrowed(origin), narrowed(direction), blur_of(narrowed(origin))),
        copy(number) {}
  Packet(const RootRay<Real>& r, const BoxRay<Real>& b, int number, bool is_unit)
      : root(r), box(b), copy(number), unit_length(is_unit) {}

  static Vec3<Real> narrowed(const Vec3<P>& v) {
    return {narrow<Real>(v.x), narrow<Real>(v.y), narrow<Real>(v.z)};
  }
  static Real blur_of(const Vec3<Real>& origin) {
    return max_of(max_of(abs_of(origin.x), abs_of(origin.y)), abs_of(origin.z)) * Real(0x1p-22F);
  }
};

}  // namespace tia
