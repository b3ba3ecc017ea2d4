#include "core/shapes/simple/triangle.h"

#include "core/input/codec.h"

namespace tia {
namespace {

double largest(const Vec3d& v) {
  return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
}

}  // namespace

void Triangle::check(const Place& at, Faults& faults) const {
  // The sine between the edges. With less, rounding would turn the normal by some 1e-4.
  constexpr double thinnest = 1e-12;
  const Vec3d to_b = b - a, to_c = c - a;
  const bool spans =
      largest(to_b) > 0 && largest(to_c) > 0 && length(cross(unit(to_b), unit(to_c))) > thinnest;
  if (!spans)
    faults.add({FaultKind::out_of_range, at.at("c").pointer(), write_value(c),
                "not on the line through a and b"});
}

// The dual basis of the edges: to_u . (b - a) = 1, to_u . (c - a) = 0, both within the plane.
TriangleForm prepare(const Triangle& triangle) {
  const Vec3d to_b = triangle.b - triangle.a, to_c = triangle.c - triangle.a;
  const Vec3d n = unit(cross(unit(to_b), unit(to_c)));
  const double twice_area = dot(n, cross(to_b, to_c));
  return {triangle.a, n, cross(to_c, n) * (1 / twice_area), cross(n, to_b) * (1 / twice_area),
          around(Aabb{triangle.a, triangle.a}, around({triangle.b, triangle.b}, triangle.c))};
}

}  // namespace tia
