#include "core/accel/packet.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tia {
namespace {

float down(double x) {
  constexpr float low = -std::numeric_limits<float>::infinity();
  const auto f = static_cast<float>(x);
  return static_cast<double>(f) > x ? std::nextafter(f, low) : f;
}
float up(double x) { return -down(-x); }

// A ray that runs in the plane of a face, no matter how far, is not to leave the box by a rounding.
double outwards(double x) { return std::max(std::fabs(x) * 0x1p-22, 1e-20); }
float below(double x) { return down(x - outwards(x)); }
float above(double x) { return up(x + outwards(x)); }

}  // namespace

Box32 rounded_outwards(const Aabb& box) {
  return {{below(box.min.x), below(box.min.y), below(box.min.z)},
          {above(box.max.x), above(box.max.y), above(box.max.z)}};
}

}  // namespace tia
