#include "core/accel/packet.h"

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

}  // namespace

Box32 rounded_outwards(const Aabb& box) {
  return {{down(box.min.x), down(box.min.y), down(box.min.z)},
          {up(box.max.x), up(box.max.y), up(box.max.z)}};
}

}  // namespace tia
