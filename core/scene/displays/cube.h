// All around as the six faces of a cube.
#pragma once

#include <string_view>

#include "core/input/fields.h"
#include "core/scene/displays/view_grid.h"

namespace tia {

/// Cube: square views of 90 degrees in the order +x -x +y -y +z -z of the frame x right, y up, z
/// the way the camera looks; each as OpenGL's cube maps have it, its first row on top.
/// Source: OpenGL 4.6 core profile, table 8.19 (selection of cube map images).
struct Cube {
  static constexpr std::string_view type = "cube";
  static constexpr DisplayNeeds needs{.own_extent = true};
  static constexpr bool square = true;

  template <class Visitor>
  static void fields(Visitor&&) {}
  ViewGrid grid(const DisplayFrame& frame) const;
  bool operator==(const Cube&) const = default;
};

}  // namespace tia
