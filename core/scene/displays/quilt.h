// The quilt: views side by side for a screen whose picture changes as one walks past it.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/input/errors.h"
#include "core/input/fields.h"
#include "core/scene/displays/interlace.h"
#include "core/scene/displays/view_grid.h"

namespace tia {

/// Quilt: N = columns * rows views, from the left to the right, counted from the bottom left tile:
/// view i has the eye moved along the camera's right by D tan((i / (N - 1) - 1/2) cone), and sees
/// the same window at the distance D. Source: Looking Glass Factory, "Quilts", 2019.
struct Quilt {
  static constexpr std::string_view type = "quilt";
  static constexpr DisplayNeeds needs{.orthographic = true, .lens = true};
  static constexpr const char* focus_field = "focus_distance";
  static constexpr int most_columns = 64;
  int columns = 8, rows = 6;
  double cone_degrees = 40;
  std::optional<double> focus_distance;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("columns", &Quilt::columns,
          Spec{.about = "how many views are side by side", .min = 1, .max = most_columns});
    visit("rows", &Quilt::rows,
          Spec{.about = "how many rows of them there are", .min = 1, .max = most_columns});
    visit("cone_degrees", &Quilt::cone_degrees,
          Spec{.about = "from the first view's eye to the last one's, as seen from the middle of "
                        "the window",
               .unit = "degrees",
               .min = 0,
               .max = 170,
               .open_min = true});
    visit("focus_distance", &Quilt::focus_distance,
          Spec{.about = "along the view's axis, to the plane that stays where it is; else to "
                        "look_at",
               .min = 0,
               .max = 1e9,
               .open_min = true});
  }
  int count() const { return columns * rows; }
  /// A single view.
  void check(const Place& at, Faults& faults) const;
  std::optional<double> focus() const { return focus_distance; }
  ViewGrid grid(const DisplayFrame& frame) const;
  /// All views in one picture, each subpixel of that which its lens shows.
  ViewGrid interlaced(const DisplayFrame& frame, const Interlace& interlace) const;
  bool operator==(const Quilt&) const = default;

 private:
  /// How far along the right each view's eye is.
  std::vector<double> eyes(double depth) const;
};

}  // namespace tia
