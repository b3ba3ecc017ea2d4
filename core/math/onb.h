// Directions: unit vectors, the orthonormal basis around one, the angle around an axis.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/math/deterministic.h"
#include "core/math/vec3.h"

namespace tia {

/// v / |v|. Domain: finite, not zero; of any length, however much its square over- or underflows.
inline Vec3d unit(const Vec3d& v) {
  const double most = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  return normalize(Vec3d{v.x / most, v.y / most, v.z / most});
}

/// Onb: an orthonormal basis, right-handed: u x v = n.
struct Onb {
  Vec3d u{1, 0, 0}, v{0, 1, 0}, n{0, 0, 1};

  /// The coordinates of a vector in this basis.
  Vec3d local(const Vec3d& w) const { return {dot(u, w), dot(v, w), dot(n, w)}; }
  bool operator==(const Onb&) const = default;
};

/// The basis around a unit vector; one of many, without a jump but where n.z changes its sign.
/// Source: Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017.
inline Onb onb_around(const Vec3d& n) {
  const double sign = std::copysign(1.0, n.z);
  const double a = -1 / (sign + n.z);
  const double b = n.x * n.y * a;
  return {{1 + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}, n};
}

/// The angle of the point (x, y) as a share of a full turn, in [0, 1).
inline double turn_of(double y, double x) {
  const double turn = atan2_of(y, x) / (2 * pi);
  const double positive = turn < 0 ? turn + 1 : turn;
  return positive < 1 ? positive : 0;  // 1 - 1e-17 has become 1
}

}  // namespace tia
