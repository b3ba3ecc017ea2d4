// Box32: boxes in float that contain boxes in double.
#pragma once

#include "core/math/aabb.h"
#include "core/math/vec3.h"

namespace tia {

/// Box32: a box in float.
struct Box32 {
  Vec3f min, max;
};
/// The least box in float that holds one in double.
Box32 enclosing(const Aabb& box);
/// A little larger (tolerance::box_face), so that a ray in the plane of one of its faces enters it
/// as well.
Box32 rounded_outwards(const Aabb& box);

/// The next float that is not above, or not below, a number.
float rounded_down(double x);
float rounded_up(double x);

}  // namespace tia
