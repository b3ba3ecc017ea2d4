// The origin of a space: it is moved near the things in the space, because rays and surface points
// are floats, whose steps grow with their distance from the origin.
#pragma once

#include <map>
#include <vector>

#include "core/accel/world/geometry.h"

namespace tia {

/// Crowd: the things in one space, and the origin for them: the mean of their centres, each
/// weighted by 1 / size, so that a floor of size 10 000 does not move it away from small things on
/// the floor. If it is near the old origin, that is kept. Scaling all things by a power of two
/// scales the new origin by the same, to the bit. Source: the reason is that of pbrt-v4's rendering
/// space (Pharr, Jakob, Humphreys, "Physically Based Rendering", 4th ed., 5.1.1), whose origin is
/// the eye; here it depends on the objects alone, because worlds with other cameras and lights
/// share them.
class Crowd {
 public:
  bool empty() const { return !(says_ > 0); }
  /// Is called first, once for each thing, with its weight. Domain: say > 0.
  void add(const Vec3d& center, double say);
  /// Is called after that, once for each thing, to measure how far apart they are.
  void measure(const Vec3d& center, double say, double size);
  /// Returns: a point whose components are multiples of a power of two near the mean size, so that
  /// subtracting it from coordinates with few digits is exact; 0 where the old origin is near.
  Vec3d origin() const;
  /// Whether that is 0 even if all sizes were half as large.
  bool is_surely_near() const;

 private:
  Vec3d middle() const { return sum_ * (1 / says_); }

  Vec3d sum_{};
  double says_ = 0, sizes_ = 0;
};

/// Moves the origin of each space of a geometry; that of the world's is recorded in
/// geometry.origin. `boxes` are the items' boxes, space by space, and are moved as well. Domain: a
/// geometry without indices. Cost: O(number of things).
void settle(Geometry& geometry, std::map<int, std::vector<Aabb>>& boxes);

/// Whether settle() would not have moved the world's origin, had it the boxes that these are
/// rounded from. Domain: a geometry whose world's origin is the scene's.
bool surely_keeps_origin(const Geometry& geometry);

}  // namespace tia
