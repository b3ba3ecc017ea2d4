#include "core/boxes/box32.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/math/tolerances.h"

namespace tia {
namespace {

// How far a face is moved, so that a ray that runs in its plane is in the box despite rounding.
double outwards(double x) {
  return std::max(std::fabs(x) * tolerance::box_face, tolerance::box_face_least);
}
float below(double x) { return rounded_down(x - outwards(x)); }
float above(double x) { return rounded_up(x + outwards(x)); }

}  // namespace

float rounded_down(double x) {
  constexpr float low = -std::numeric_limits<float>::infinity();
  const auto f = static_cast<float>(x);
  return static_cast<double>(f) > x ? std::nextafter(f, low) : f;
}
float rounded_up(double x) { return -rounded_down(-x); }

Box32 enclosing(const Aabb& box) {
  return {{rounded_down(box.min.x), rounded_down(box.min.y), rounded_down(box.min.z)},
          {rounded_up(box.max.x), rounded_up(box.max.y), rounded_up(box.max.z)}};
}
Box32 rounded_outwards(const Aabb& box) {
  return {{below(box.min.x), below(box.min.y), below(box.min.z)},
          {above(box.max.x), above(box.max.y), above(box.max.z)}};
}

}  // namespace tia
