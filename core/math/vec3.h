// Three-component vectors over any scalar: float, double or Wide (registers of float lanes).
// Points, directions and linear RGB colours are all Vec3; there is no matrix here.
#pragma once

#include <cmath>

namespace tia {

/// Vec3: a point, direction or linear RGB triple. Sums run x, y, z, in that order, so that every
/// scalar and every compiler rounds alike.
template <class Real>
struct Vec3 {
  Real x, y, z;

  template <class Other>
  explicit operator Vec3<Other>() const {
    return {Other(x), Other(y), Other(z)};
  }
  bool operator==(const Vec3&) const = default;
};

using Vec3d = Vec3<double>;
using Vec3f = Vec3<float>;

template <class R>
Vec3<R> operator+(const Vec3<R>& a, const Vec3<R>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class R>
Vec3<R> operator-(const Vec3<R>& a, const Vec3<R>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class R>
Vec3<R> operator-(const Vec3<R>& a) {
  return {-a.x, -a.y, -a.z};
}
template <class R>
Vec3<R> operator*(const Vec3<R>& a, const R& s) {
  return {a.x * s, a.y * s, a.z * s};
}
template <class R>
Vec3<R> operator*(const R& s, const Vec3<R>& a) {
  return a * s;
}
/// Component-wise product: a surface colour filters a light.
template <class R>
Vec3<R> operator*(const Vec3<R>& a, const Vec3<R>& b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}

template <class R>
R dot(const Vec3<R>& a, const Vec3<R>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class R>
Vec3<R> cross(const Vec3<R>& a, const Vec3<R>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class R>
R length(const Vec3<R>& a) {
  using std::sqrt;  // Wide brings its own
  return sqrt(dot(a, a));
}
/// Domain: a finite, non-zero vector whose squared length neither overflows nor vanishes.
template <class R>
Vec3<R> normalize(const Vec3<R>& a) {
  return a * (R(1) / length(a));
}

}  // namespace tia
