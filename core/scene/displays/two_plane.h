// Two planes: a grid of eyes that look through one window, as archives of light fields have it.
#pragma once

#include <array>
#include <string_view>

#include "core/input/fields.h"
#include "core/scene/displays/view_grid.h"

namespace tia {

/// EyeGrid: columns x rows of eyes, in the plane of the camera's right and up, around its location.
struct EyeGrid {
  static constexpr std::string_view schema_name = "eye_grid";
  static constexpr int most = 64;
  int columns = 1, rows = 1;
  double spacing = 0;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("columns", &EyeGrid::columns,
          Spec{.about = "eyes side by side", .min = 1, .max = most, .required = true});
    visit("rows", &EyeGrid::rows,
          Spec{.about = "rows of eyes", .min = 1, .max = most, .required = true});
    visit("spacing", &EyeGrid::spacing,
          Spec{.about = "between neighbours",
               .min = 0,
               .max = 1e9,
               .open_min = true,
               .required = true});
  }
  bool operator==(const EyeGrid&) const = default;
};

/// TwoPlane: rows from the top, each from the left; the window `st` stands around look_at, across
/// the camera's axis. Source: Levoy and Hanrahan, "Light field rendering", SIGGRAPH 1996.
struct TwoPlane {
  static constexpr std::string_view type = "two_plane";
  static constexpr DisplayNeeds needs{.lens = true, .own_extent = true, .look_at = true};
  std::array<double, 2> st{1, 1};
  EyeGrid uv;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("st", &TwoPlane::st,
          Spec{.about = "the window's width and height, around look_at",
               .min = 0,
               .max = 1e9,
               .open_min = true,
               .required = true});
    visit("uv", &TwoPlane::uv, Spec{.about = "the eyes, around location", .required = true});
  }
  ViewGrid grid(const DisplayFrame& frame) const;
  bool operator==(const TwoPlane&) const = default;
};

}  // namespace tia
