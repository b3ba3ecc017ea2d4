// The bounds that a formula's surface is clipped to: a box or a ball.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <variant>

#include "core/math/octet.h"
#include "core/shapes/simple/box.h"
#include "core/shapes/simple/chord.h"
#include "core/shapes/simple/sphere.h"

namespace tia {

/// Bounds: `min` and `max`, or `center` and `radius`. Space/units: scene units, object space.
struct Bounds {
  static constexpr std::array<std::array<std::string_view, 2>, 2> spellings{
      {{"min", "max"}, {"center", "radius"}}};
  std::optional<Vec3d> min, max, center;
  std::optional<double> radius;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("min", &Bounds::min,
          Spec{.about = "a box's corner of least coordinates", .min = -1e9, .max = 1e9});
    visit("max", &Bounds::max,
          Spec{.about = "a box's corner of greatest coordinates", .min = -1e9, .max = 1e9});
    visit("center", &Bounds::center, Spec{.about = "a ball's centre", .min = -1e9, .max = 1e9});
    visit("radius", &Bounds::radius,
          Spec{.about = "a ball's radius", .min = 0, .max = 1e9, .open_min = true});
  }
  /// Both spellings, half of one, neither; an empty box.
  void check(const Place& at, Faults& faults) const;
  bool operator==(const Bounds&) const = default;
};

/// Region: bounds made ready, a form like its two kinds.
struct Region {
  static constexpr bool solid = true;
  std::variant<Box, Sphere> kind;
};

/// Domain: bounds that their check has passed.
inline Region prepare(const Bounds& b) {
  if (b.radius) return {Sphere{*b.center, *b.radius}};
  return {Box{*b.min, *b.max}};
}
inline int elements(const Region& region) {
  return std::visit([](const auto& kind) { return elements(kind); }, region.kind);
}
inline Aabb bounds(const Region& region) {
  return std::visit([](const auto& kind) { return bounds(kind); }, region.kind);
}
template <class Emit>
void crossings(const Region& region, const Line& line, Emit&& emit) {
  std::visit([&](const auto& kind) { crossings(kind, line, emit); }, region.kind);
}
inline Vec3d normal(const Region& region, const Vec3d& p, int element) {
  return std::visit([&](const auto& kind) { return normal(kind, p, element); }, region.kind);
}
inline Vec2d uv(const Region& region, const Vec3d& p, int element) {
  return std::visit([&](const auto& kind) { return uv(kind, p, element); }, region.kind);
}

static_assert(IsForm<Region>);

/// What the bounds hold of a line, all of it where there are none. Its ends' elements are the
/// region's from 1 up: 0 is the surface that is clipped.
Chord chord(const std::optional<Region>& bounds, const Line& line);

/// EightChords: the stretch of each lane's line, its ends those of chord(); empty where out < in.
struct EightChords {
  Octet in, out;
};
EightChords chords(const Region& bounds, const Ray<Octet>& line);

}  // namespace tia
