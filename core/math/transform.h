// Affine maps of space in double.
#pragma once

#include "core/math/aabb.h"
#include "core/math/vec3.h"

namespace tia {

/// Affine: p -> x p.x + y p.y + z p.z + offset; x, y, z are where the axes go.
struct Affine {
  Vec3d x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, offset{};

  static Affine translation(const Vec3d& by) { return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, by}; }
  static Affine scaling(const Vec3d& by) { return {{by.x, 0, 0}, {0, by.y, 0}, {0, 0, by.z}, {}}; }
  /// About x, then y, then z, counter-clockwise seen from the axis' tip.
  static Affine rotation_degrees(const Vec3d& by);

  /// What a vector or a point becomes, in double or in lanes of it.
  template <class P>
  Vec3<P> vector(const Vec3<P>& v) const {
    return {P(x.x) * v.x + P(y.x) * v.y + P(z.x) * v.z, P(x.y) * v.x + P(y.y) * v.y + P(z.y) * v.z,
            P(x.z) * v.x + P(y.z) * v.y + P(z.z) * v.z};
  }
  template <class P>
  Vec3<P> point(const Vec3<P>& p) const {
    const Vec3<P> v = vector(p);
    return {v.x + P(offset.x), v.y + P(offset.y), v.z + P(offset.z)};
  }
  /// What a row vector becomes: the inverse's `row` carries normals outwards, n -> n M^-1.
  template <class P>
  Vec3<P> row(const Vec3<P>& n) const {
    return {P(x.x) * n.x + P(x.y) * n.y + P(x.z) * n.z, P(y.x) * n.x + P(y.y) * n.y + P(y.z) * n.z,
            P(z.x) * n.x + P(z.y) * n.y + P(z.z) * n.z};
  }

  /// Signed volume of what the unit cube becomes.
  double determinant() const { return dot(x, cross(y, z)); }
  /// Domain: a determinant other than 0.
  Affine inverse() const;
  bool operator==(const Affine&) const = default;
};

/// First `inner`, then `outer`.
Affine operator*(const Affine& outer, const Affine& inner);

/// The box around what a box becomes; an infinite box stays all of space.
Aabb bounds_of(const Affine& map, const Aabb& box);

}  // namespace tia
