// The box along the axes, by slabs. A transform turns it into an oriented one.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

#include "core/input/errors.h"
#include "core/input/fields.h"
#include "core/shapes/simple/chord.h"

namespace tia {

/// Box. Surface: the six faces of min <= p <= max, elements 0 to 5: -x, +x, -y, +y, -z, +z.
/// Space/units: scene units, object space.
struct Box {
  static constexpr std::string_view type = "box";
  static constexpr bool solid = true;
  Vec3d min{}, max{};

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit(
        "min", &Box::min,
        Spec{
            .about = "the corner of least coordinates", .min = -1e9, .max = 1e9, .required = true});
    visit("max", &Box::max,
          Spec{.about = "the corner of greatest coordinates",
               .min = -1e9,
               .max = 1e9,
               .required = true});
  }
  void check(const Place& at, Faults& faults) const;
  bool operator==(const Box&) const = default;
};

inline Box prepare(const Box& box) { return box; }
inline int elements(const Box&) { return 6; }
inline Aabb bounds(const Box& box) { return {box.min, box.max}; }

/// A line in the plane of a face is inside at the min faces and outside at the max faces: boxes
/// side by side share no point of it.
/// Source: Kay, Kajiya, "Ray Tracing Complex Scenes", SIGGRAPH 1986.
template <class Emit>
void crossings(const Box& box, const Line& line, Emit&& emit) {
  const std::array o{line.origin.x, line.origin.y, line.origin.z};
  const std::array d{line.direction.x, line.direction.y, line.direction.z};
  const std::array low{box.min.x, box.min.y, box.min.z}, high{box.max.x, box.max.y, box.max.z};
  Chord held = Chord::everything();
  for (std::size_t i = 0; i < 3; ++i) {
    if (d[i] == 0) {
      if (!(low[i] <= o[i] && o[i] < high[i])) return;
      continue;
    }
    const double to_low = (low[i] - o[i]) / d[i], to_high = (high[i] - o[i]) / d[i];
    const bool up = d[i] > 0;
    const double near = up ? to_low : to_high, far = up ? to_high : to_low;
    if (!(near <= far)) return;  // NaN
    const int face = 2 * static_cast<int>(i);
    if (near > held.in.t) held.in = {near, up ? face : face + 1};
    if (far < held.out.t) held.out = {far, up ? face + 1 : face};
  }
  if (held.out.t < Aabb::far) emit_ends(held, emit);
}

inline Vec3d normal(const Box&, const Vec3d&, int element) {
  const double way = element % 2 == 0 ? -1 : 1;
  return {element / 2 == 0 ? way : 0, element / 2 == 1 ? way : 0, element / 2 == 2 ? way : 0};
}
/// Returns: the place between min and max along the two axes of the face: y z, z x or x y.
inline Vec2d uv(const Box& box, const Vec3d& p, int element) {
  const Vec3d size = box.max - box.min, q = p - box.min;
  const auto share = [](double part, double whole) { return std::clamp(part / whole, 0.0, 1.0); };
  const double x = share(q.x, size.x), y = share(q.y, size.y), z = share(q.z, size.z);
  return element / 2 == 0 ? Vec2d{y, z} : element / 2 == 1 ? Vec2d{z, x} : Vec2d{x, y};
}

static_assert(IsForm<Box>);

}  // namespace tia
