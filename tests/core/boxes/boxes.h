// Boxes by chance, and an index of them.
#pragma once

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

}  // namespace tia::test
