// LightBounds: what a tree of lights knows of one or several lights, and how much it weighs them.
#pragma once

#include "core/math/aabb.h"

namespace tia {

/// LightBounds: where one or several lights are and how much they shine whereto: within `cos_o` of
/// the axis are all directions that they face, and within cos_e of those all that they shine in.
struct LightBounds {
  Aabb box{};
  double power = 0;
  Vec3d axis{0, 0, 1};
  double cos_o = -1, cos_e = 0;
  bool two_sided = false;

  /// About how much a surface at p with the normal n, to either side, may get; 0 where it gets
  /// none; of n = 0, a point within a medium. Domain: else a unit normal.
  double importance(const Vec3d& p, const Vec3d& n) const;
};
LightBounds around(const LightBounds& a, const LightBounds& b);

}  // namespace tia
