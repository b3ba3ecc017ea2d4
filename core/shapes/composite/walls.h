// Walls of a floor plan: upright runs along a line, of one height and thickness, with openings for
// doors and windows. They are lowered to boxes (wall_pieces.h) when they are read.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "core/input/errors.h"
#include "core/input/fields.h"

namespace tia {

struct Object;

/// Opening: where a wall is left out, from its sill up to its lintel. Space/units: `from` and `to`
/// along the walls' line from its first point, `sill` and `lintel` above the walls' foot.
struct Opening {
  double from = 0, to = 0, sill = 0;
  std::optional<double> lintel;  ///< none: the walls' height

  template <class Visitor>
  static void fields(Visitor&& visit) {
    constexpr double far = 1e12;  // a line of most_points
    visit("from", &Opening::from,
          Spec{.about = "where it begins, along the line", .min = 0, .max = far, .required = true});
    visit("to", &Opening::to,
          Spec{.about = "where it ends, along the line", .min = 0, .max = far, .required = true});
    visit("sill", &Opening::sill,
          Spec{.about = "the height of the wall below it", .min = 0, .max = 1e9});
    visit("lintel", &Opening::lintel,
          Spec{.about = "where the wall above it begins; else there is none",
               .min = 0,
               .max = 1e9,
               .open_min = true});
  }
  bool operator==(const Opening&) const = default;
};

/// Walls. Surface: what is within half the thickness of the line from point to point, corners
/// mitred, from y = 0 up to the height, without the openings; each part of space is in one piece.
/// Space/units: scene units, object space; points are x and z.
struct Walls {
  static constexpr std::string_view type = "walls";
  static constexpr bool one_object = false;
  static constexpr std::size_t most_points = 512;
  using Point = std::array<double, 2>;
  std::vector<Point> points;
  bool closed = false;
  double height = 0, thickness = 0;
  std::vector<Opening> openings;

  /// What they are lowered to; null until they are checked. Copies share it. No part of the JSON,
  /// and none of what is compared: it follows from the rest.
  std::shared_ptr<const std::vector<Object>> shown{};

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("points", &Walls::points,
          Spec{.about = "x and z of the middle line's corners, of at most 512",
               .min = -1e9,
               .max = 1e9,
               .required = true,
               .min_items = 2});
    visit("closed", &Walls::closed, Spec{.about = "whether the last point is joined to the first"});
    visit("height", &Walls::height,
          Spec{.about = "how high they stand above y = 0",
               .min = 0,
               .max = 1e9,
               .open_min = true,
               .required = true});
    visit("thickness", &Walls::thickness,
          Spec{.about = "how thick they are, half of it to either side of the line",
               .min = 0,
               .max = 1e9,
               .open_min = true,
               .required = true});
    visit("openings", &Walls::openings,
          Spec{.about = "doors and windows, each in one run between two corners"});
  }
  /// Points that coincide, corners without room, runs in each other's way; openings that are not
  /// within a run, or in each other's way. Where nothing is wrong it makes `shown`.
  void check(const Place& at, Faults& faults);
  /// Of what is written.
  bool operator==(const Walls& other) const;
};

/// What they are lowered to; nothing until they are checked.
const std::vector<Object>& children_in(const Walls& walls);

}  // namespace tia
