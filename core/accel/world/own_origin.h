// Where the origin of a space is put so that float keeps what stands in it apart: rays, and points
// of surfaces, are floats, whose steps grow with the distance from there.
#pragma once

#include <map>
#include <vector>

#include "core/accel/world/geometry.h"

namespace tia {

/// Crowd: things that stand in one space, and the origin that suits them: their middle, each with a
/// say of 1 / size, so that a floor of 10 000 does not move it away from what stands on it. Things
/// that stand near the origin as it is keep that.
/// Scaling all by a power of two scales the new origin alike, to the bit.
/// Source: the reason is that of pbrt-v4's rendering space (Pharr, Jakob, Humphreys, "Physically
/// Based Rendering", 4th ed., 5.1.1), whose origin is the eye; here it depends on the objects
/// alone, because worlds share them that cameras and lights move in.
class Crowd {
 public:
  bool empty() const { return !(says_ > 0); }
  /// First each thing once. Domain: say > 0.
  void add(const Vec3d& center, double say);
  /// Then each thing again.
  void measure(const Vec3d& center, double say, double size);
  /// Returns: a point whose components are multiples of a power of two of about the size of what
  /// is there, so that taking it off keeps the digits of short numbers; 0 where that is near.
  Vec3d origin() const;

 private:
  Vec3d middle() const { return sum_ * (1 / says_); }

  Vec3d sum_{};
  double says_ = 0, sizes_ = 0;
};

/// Moves the origin of each space of a geometry amid what stands there, the world's into its
/// `origin`. `boxes` are those of the items, space by space, and move along.
/// Domain: a geometry without indices. Cost: O(all that stands there).
void settle(Geometry& geometry, std::map<int, std::vector<Aabb>>& boxes);

}  // namespace tia
