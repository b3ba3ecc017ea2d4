// A packet of rays, one in each lane of a register, or a single ray, in the forms that the tests
// with boxes and surfaces need.
#pragma once

#include <array>
#include <cstdint>

#include "core/boxes/box_ray.h"
#include "core/math/octet.h"
#include "core/math/ray.h"
#include "core/math/tolerances.h"
#include "core/math/transform.h"
#include "core/shapes/crossing.h"

namespace tia {

/// Lines: the rays of the lanes in double, for access one by one.
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

/// Packet: rays in one space of the world. Space/units: t has the same meaning in every space,
/// because directions are transformed without being normalized.
template <class Real>
class Packet {
 public:
  using P = Precise<Real>;

  explicit Packet(const Ray<Real>& ray)
      : root(ray), box(ray.origin, ray.direction, Real(0)), unit_length(true) {}

  Packet<float> one(int i) const { return {root.one(i), box.one(i), instance, unit_length}; }
  /// The same rays in the space that `map` leads to.
  Packet seen_through(const Affine& map) const {
    return {map.point(root.origin), map.vector(root.direction), instance};
  }
  /// The same rays seen from an instance of the space that stands at `offset`.
  Packet inside_instance(const Vec3d& offset, int number) const {
    Packet inside(root, box, number, unit_length);
    inside.root.origin = root.origin - static_cast<Vec3<P>>(offset);
    const Vec3<Real> origin = narrowed(inside.root.origin);
    inside.box = box.from(origin, blur_of(origin));
    return inside;
  }

  RootRay<Real> root;
  BoxRay<Real> box;
  int instance = 0;          ///< which instance of repeated groups the rays are in
  bool unit_length = false;  ///< whether directions are unit, up to float's rounding

 private:
  template <class>
  friend class Packet;
  Packet(const Vec3<P>& origin, const Vec3<P>& direction, int number)
      : root(origin, direction),
        box(narrowed(origin), narrowed(direction), blur_of(narrowed(origin))),
        instance(number) {}
  Packet(const RootRay<Real>& r, const BoxRay<Real>& b, int number, bool is_unit)
      : root(r), box(b), instance(number), unit_length(is_unit) {}

  static Vec3<Real> narrowed(const Vec3<P>& v) {
    return {narrow<Real>(v.x), narrow<Real>(v.y), narrow<Real>(v.z)};
  }
  static Real blur_of(const Vec3<Real>& origin) {
    return max_of(max_of(abs_of(origin.x), abs_of(origin.y)), abs_of(origin.z)) *
           Real(tolerance::group_origin);
  }
};

}  // namespace tia
