#include "core/shapes/box_tree.h"

#include <cmath>
#include <limits>

namespace tia {
namespace {

constexpr float far = std::numeric_limits<float>::infinity();

}  // namespace

float detail::rounded_down(double x) {
  const auto f = static_cast<float>(x);
  return f <= x ? f : std::nextafter(f, -far);
}
float detail::rounded_up(double x) { return -rounded_down(-x); }

BoxTree::Node::Node() {
  for (auto& each : low) each.fill(far);
  for (auto& each : high) each.fill(-far);
  child.fill(nothing);
}

void BoxTree::Node::set(std::size_t i, const Aabb& b, std::int32_t what) {
  const std::array<double, 3> from{b.min.x, b.min.y, b.min.z}, to{b.max.x, b.max.y, b.max.z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    low[axis][i] = detail::rounded_down(from[axis]);
    high[axis][i] = detail::rounded_up(to[axis]);
  }
  child[i] = what;
}

detail::BoxLine::BoxLine(const Line& line, const Vec3d& middle) {
  const Vec3d from = line.origin - middle, &way = line.direction;
  origin = {static_cast<float>(from.x), static_cast<float>(from.y), static_cast<float>(from.z)};
  inverse = {static_cast<float>(1 / way.x), static_cast<float>(1 / way.y),
             static_cast<float>(1 / way.z)};
}

}  // namespace tia
