// What the patterns of space share: where a pattern stands, and a list of colours to run through.
#pragma once

#include <concepts>
#include <vector>

#include "core/input/codec.h"
#include "core/input/transform_steps.h"
#include "core/math/heap.h"
#include "core/shapes/crossing.h"

namespace tia {

/// Pattern: what every pattern of space says besides its colours. It fills the space of the object,
/// of which the surface shows a part. Space/units: scene units, object space.
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

/// PatternSpace: from object space to the pattern's own, in which a cell has the size 1.
struct PatternSpace {
  Affine to_pattern;     ///< the transform undone
  double scale = 1;      ///< by which the result is divided, for that rounds but once
  Vec3d reach{1, 1, 1};  ///< how far a step of 1 in object space can go along each axis
  Vec3d point(const Vec3d& p) const;
  /// What an error in the place of a point may make of each coordinate.
  Vec3d blur(double length) const { return reach * length; }
};
PatternSpace prepare(const Pattern& pattern);

/// floor(x), but a number that lies less than `blur` below an integer counts as that integer.
///
/// A point that was computed lies a little off its surface, on this side or that. The plane y = 0
/// would show both colours of a checker in speckles, as would every face of a box that ends where
/// a cell does.
inline double floor_of(double x, double blur) { return std::floor(x + blur); }
/// x - floor(x), in [0, 1]; 0 where x counts as an integer that it lies below.
inline double fraction_of(double x, double blur) {
  const double rest = x - floor_of(x, blur);
  return rest > 0 ? rest : 0;
}

/// The colours of patterns that have two.
using TwoColors = std::array<Color, 2>;
inline constexpr TwoColors black_on_white{Color{1, 1, 1}, Color{0, 0, 0}};
inline constexpr Spec two_colors{.about = "the linear RGB of even and odd cells", .max = 1e6};

/// The colours of patterns that run through a list.
using ColorStops = std::vector<Color>;
inline constexpr Spec color_stops{.about =
                                      "linear RGB at even distances from 0 to 1, straight "
                                      "lines between",
                                  .max = 1e6,
                                  .min_items = 2};
inline ColorStops white_to_black() { return {Color{1, 1, 1}, Color{0, 0, 0}}; }

inline Vec3d rgb_of(const Color& color) { return {color.r, color.g, color.b}; }

/// Ramp: stops made ready.
struct Ramp {
  std::vector<Vec3d> stops;

  Ramp() = default;
  /// Domain: at least one colour.
  explicit Ramp(const ColorStops& colors);
  /// Domain: any; below 0 as 0, above 1 as 1, NaN as 0.
  Vec3d at(double share) const;
};

/// A form whose colours run through a ramp owns its stops.
template <class Form>
concept HasRamp = requires(const Form& form) {
  { form.ramp } -> std::same_as<const Ramp&>;
};
template <HasRamp Form>
std::size_t heap_bytes(const Form& form) {
  return heap_bytes(form.ramp.stops);
}

}  // namespace tia
