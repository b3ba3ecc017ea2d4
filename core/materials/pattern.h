// What solid textures have in common: scale and transform, and lists of colours.
#pragma once

#include <concepts>
#include <vector>

#include "core/input/codec.h"
#include "core/input/transform_steps.h"
#include "core/math/heap.h"
#include "core/shapes/crossing.h"

namespace tia {

/// Pattern: the fields of every solid texture besides its colours. The texture is a function of the
/// point in object space. Space/units: scene units, object space.
struct Pattern {
  double scale = 1;
  TransformSteps transform;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("scale", &Pattern::scale,
          Spec{.about = "the size of a cell, a stripe, a vein, a ring",
               .min = 0,
               .max = 1e9,
               .open_min = true});
    visit("transform", &Pattern::transform,
          Spec{.about = "steps that place it in the object, the first step first, after scale"});
  }
  bool operator==(const Pattern&) const = default;
};

/// PatternSpace: the map from object space to the pattern's own, in which a cell has the size 1.
struct PatternSpace {
  Affine to_pattern;     ///< the inverse of the transform
  double scale = 1;      ///< the result is divided by it, which rounds once
  Vec3d reach{1, 1, 1};  ///< the longest that a unit vector of object space can be along each axis
  Vec3d point(const Vec3d& p) const;
  /// By how much an error of that length in a point may change each coordinate.
  Vec3d blur(double length) const { return reach * length; }
};
PatternSpace prepare(const Pattern& pattern);

/// floor(x), but a number that lies less than `blur` below an integer counts as that integer.
///
/// A hit point is a little off its surface, on either side. Without the blur the plane y = 0 would
/// show both colours of a checker in speckles, and so would a face of a box along the edges of
/// cells.
inline double floor_of(double x, double blur) { return std::floor(x + blur); }
/// x - floor(x), in [0, 1]; 0 where x counts as an integer that it lies below.
inline double fraction_of(double x, double blur) {
  const double rest = x - floor_of(x, blur);
  return rest > 0 ? rest : 0;
}

/// The colours of patterns with two colours.
using TwoColors = std::array<Color, 2>;
inline constexpr TwoColors black_on_white{Color{1, 1, 1}, Color{0, 0, 0}};
inline constexpr Spec two_colors{.about = "the linear RGB of even and odd cells", .max = 1e6};

/// The colours of patterns with a gradient.
using ColorStops = std::vector<Color>;
inline constexpr Spec color_stops{.about =
                                      "linear RGB at even distances from 0 to 1, straight "
                                      "lines between",
                                  .max = 1e6,
                                  .min_items = 2};
inline ColorStops white_to_black() { return {Color{1, 1, 1}, Color{0, 0, 0}}; }

inline Vec3d rgb_of(const Color& color) { return {color.r, color.g, color.b}; }

/// Ramp: a piecewise linear gradient through stops at equal distances.
struct Ramp {
  std::vector<Vec3d> stops;

  Ramp() = default;
  /// Domain: at least one colour.
  explicit Ramp(const ColorStops& colors);
  /// Domain: any number. Below 0 is as 0, above 1 as 1, NaN as 0.
  Vec3d at(double share) const;
};

/// A form with a ramp owns the ramp's stops.
template <class Form>
concept HasRamp = requires(const Form& form) {
  { form.ramp } -> std::same_as<const Ramp&>;
};
template <HasRamp Form>
std::size_t heap_bytes(const Form& form) {
  return heap_bytes(form.ramp.stops);
}

}  // namespace tia
