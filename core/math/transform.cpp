#include "core/math/transform.h"

#include "core/math/deterministic.h"

namespace tia {
namespace {

struct Rotation {
  double c, s;
  explicit Rotation(double degrees) : c(cos_degrees(degrees)), s(sin_degrees(degrees)) {}
};

}  // namespace

Affine Affine::rotation_degrees(const Vec3d& by) {
  const Rotation a(by.x), b(by.y), c(by.z);
  const Affine about_x{{1, 0, 0}, {0, a.c, a.s}, {0, -a.s, a.c}, {}};
  const Affine about_y{{b.c, 0, -b.s}, {0, 1, 0}, {b.s, 0, b.c}, {}};
  const Affine about_z{{c.c, c.s, 0}, {-c.s, c.c, 0}, {0, 0, 1}, {}};
  return about_z * (about_y * about_x);
}

Affine Affine::inverse() const {
  const double inverse_determinant = 1 / determinant();
  // The rows of the inverse, by Cramer's rule.
  const Vec3d a = cross(y, z) * inverse_determinant;
  const Vec3d b = cross(z, x) * inverse_determinant;
  const Vec3d c = cross(x, y) * inverse_determinant;
  Affine inverse{{a.x, b.x, c.x}, {a.y, b.y, c.y}, {a.z, b.z, c.z}, {}};
  inverse.offset = -inverse.vector(offset);
  return inverse;
}

Affine operator*(const Affine& outer, const Affine& inner) {
  return {outer.vector(inner.x), outer.vector(inner.y), outer.vector(inner.z),
          outer.point(inner.offset)};
}

// Each corner moves by the sum of what the three half edges become; of the eight sums the largest
// in a component adds the magnitudes.
Aabb bounds_of(const Affine& map, const Aabb& box) {
  if (box.empty()) return box;
  if (!box.bounded()) return Aabb::everything();
  const Vec3d half = box.size() * 0.5;
  const Vec3d center = map.point(box.center());
  const auto reach = [&](double Vec3d::*i) {
    return std::fabs(map.x.*i) * half.x + std::fabs(map.y.*i) * half.y +
           std::fabs(map.z.*i) * half.z;
  };
  const Vec3d extent{reach(&Vec3d::x), reach(&Vec3d::y), reach(&Vec3d::z)};
  return {center - extent, center + extent};
}

}  // namespace tia
