// ViewGrid: the views that a picture is made of, and where each is in it.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/scene/view.h"

namespace tia {

/// Mix: what share of a view's red, green and blue goes into each of the picture's: rows.
using Mix = std::array<Vec3f, 3>;
inline constexpr Mix only_red{{{1, 0, 0}, {0, 0, 0}, {0, 0, 0}}};
inline constexpr Mix only_green{{{0, 0, 0}, {0, 1, 0}, {0, 0, 0}}};
inline constexpr Mix only_blue{{{0, 0, 0}, {0, 0, 0}, {0, 0, 1}}};
inline constexpr Mix green_and_blue{{{0, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

/// GridView: one of them.
struct GridView {
  View view;
  int column = 0, row = 0;   ///< from the top left, in views
  std::string name;          ///< of its file among others
  std::optional<Mix> mix{};  ///< of a view that shares its place with others
};

/// ViewGrid: views in their order, all of one size. Shape: columns x rows places, each of which has
/// one view or a few that are mixed; a last row may be without.
struct ViewGrid {
  int columns = 1, rows = 1;
  std::vector<GridView> views;
  std::string suffix{};     ///< of the picture's file name, by which viewers know what it is
  double window_depth = 1;  ///< along the axes, to the window that eyes share, where they do

  bool is_mixed() const { return views.front().mix.has_value(); }
};

/// DisplayFrame: what a display knows of its camera.
struct DisplayFrame {
  View view;        ///< the camera's own
  Vec3d right, up;  ///< unit, perpendicular to each other and to view.axis
  std::optional<Vec3d> look_at{};

  /// How far before the eye along the axis what is looked at is: `asked`, else look_at.
  double depth(const std::optional<double>& asked) const {
    return asked ? *asked : dot(look_at.value_or(view.origin + view.axis) - view.origin, view.axis);
  }
};

/// DisplayNeeds: of which cameras a display may be.
struct DisplayNeeds {
  bool orthographic = false;  ///< of parallel rays, too
  bool lens = false;          ///< of one with a lens
  bool own_extent = false;    ///< says itself how much it sees, not the camera
  bool panorama = false;      ///< the projection may be equirectangular, which it is anyhow
  bool look_at = false;       ///< needs what the camera looks at
};

/// "view_07", with as many digits as the last of so many has.
std::string numbered_view(int number, int count);

}  // namespace tia
