// Boxes by chance, and an index of them.
#pragma once

#include <algorithm>
#include <vector>

#include "core/boxes/bvh_builder.h"
#include "tests/core/support.h"

namespace tia::test {

inline Aabb random_box(Random& random, double extent, double size) {
  const Vec3d at = random.point(extent);
  const double x = random.in(0, size), y = random.in(0, size);
  return {at, at + Vec3d{x, y, random.in(0, size)}};
}

inline Bvh built(const std::vector<Aabb>& boxes) {
  std::vector<Box32> rounded;
  for (const Aabb& box : boxes) rounded.push_back(rounded_outwards(box));
  return build_bvh(rounded);
}

/// What a box test must never miss: the ray, exact in long double, within the box for some t in
/// [0, t_max].
inline bool ray_meets(const Aabb& box, const Ray<float>& ray, double t_max) {
  Long near = 0, far = t_max;
  const auto slab = [&](Long low, Long high, Long o, Long d) {
    if (d == 0) {
      if (o < low || o > high) far = -1;
      return;
    }
    const Long a = (low - o) / d, b = (high - o) / d;
    near = std::max(near, std::min(a, b));
    far = std::min(far, std::max(a, b));
  };
  slab(box.min.x, box.max.x, ray.origin.x, ray.direction.x);
  slab(box.min.y, box.max.y, ray.origin.y, ray.direction.y);
  slab(box.min.z, box.max.z, ray.origin.z, ray.direction.z);
  return near <= far;
}

}  // namespace tia::test
