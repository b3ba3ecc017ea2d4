// THE LIST of projections: what a camera's picture is of. A new one is a file beside this one with
// its rays (fisheye.h), its name and its row here, and its place among the forms.
#pragma once

#include <array>
#include <string_view>
#include <variant>

#include "core/input/fields.h"
#include "core/scene/projections/cylindrical.h"
#include "core/scene/projections/equirectangular.h"
#include "core/scene/projections/fisheye.h"
#include "core/scene/projections/lenticular.h"
#include "core/scene/projections/module_image.h"
#include "core/scene/projections/module_slice.h"

namespace tia {

enum class Projection { perspective, orthographic, fisheye, equirectangular, cylindrical };

/// FlatView: all that looks through a plane, whose rays are View's own.
struct FlatView {};

/// CurvedView: the rays of a view, where they are no plane's: of projections, and of displays.
using CurvedView = std::variant<FlatView, FisheyeView, EquirectangularView, CylindricalView,
                                ModuleImage, ModuleSlice, LenticularView>;

/// ProjectionRow: all there is to say of a projection but its rays.
struct ProjectionRow {
  Projection projection;
  std::string_view text;
  bool is_flat = false;       ///< looks through a plane, and so may have near, far and a view plane
  bool has_lens = false;      ///< may have one
  bool takes_fov = false;     ///< fov_degrees says how much it sees,
  bool takes_angle = false;   ///< or angle_degrees,
  bool takes_height = false;  ///< and height
  double usual_angle = 0;     ///< degrees
  CurvedView (*make)(const SeenAngle&) = nullptr;  ///< of one that is not flat
};

template <class Form>
CurvedView form_of(const SeenAngle& seen) {
  return Form::of(seen);
}

inline constexpr std::array projections = std::to_array<ProjectionRow>({
    {.projection = Projection::perspective,
     .text = "perspective",
     .is_flat = true,
     .has_lens = true,
     .takes_fov = true},
    {.projection = Projection::orthographic,
     .text = "orthographic",
     .is_flat = true,
     .takes_height = true},
    {.projection = Projection::fisheye,
     .text = "fisheye",
     .takes_angle = true,
     .usual_angle = 180,
     .make = form_of<FisheyeView>},
    {.projection = Projection::equirectangular,
     .text = "equirectangular",
     .make = form_of<EquirectangularView>},
    {.projection = Projection::cylindrical,
     .text = "cylindrical",
     .takes_angle = true,
     .takes_height = true,
     .usual_angle = 360,
     .make = form_of<CylindricalView>},
});
static_assert(
    [] {
      for (std::size_t i = 0; i < projections.size(); ++i)
        if (static_cast<std::size_t>(projections[i].projection) != i) return false;
      return true;
    }(),
    "the rows stand in the order of the projections, one a projection");

constexpr const ProjectionRow& row_of(Projection projection) {
  return projections[static_cast<std::size_t>(projection)];
}

template <>
struct Names<Projection> {
  static constexpr auto names = [] {
    std::array<std::string_view, projections.size()> all;
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = projections[i].text;
    return all;
  }();
};

}  // namespace tia
