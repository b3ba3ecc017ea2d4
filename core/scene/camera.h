// The camera as the scene writes it, in any of its spellings. What they all become is view.h's.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "core/input/errors.h"
#include "core/input/fields.h"
#include "core/math/vec3.h"
#include "core/scene/displays/display.h"
#include "core/scene/displays/interlace.h"
#include "core/scene/projections/projection.h"

namespace tia {

/// Basis: AlgoWiki's frame of the camera, right-handed and orthonormal: u right, v up, w towards
/// the viewer.
struct Basis {
  Vec3d u{1, 0, 0}, v{0, 1, 0}, w{0, 0, 1};

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("u", &Basis::u, Spec{.about = "to the right", .required = true});
    visit("v", &Basis::v, Spec{.about = "upwards", .required = true});
    visit("w", &Basis::w, Spec{.about = "towards the viewer", .required = true});
  }
  /// Lengths other than 1, angles other than right ones, a left-handed frame, each beyond 1e-6.
  void check(const Place& at, Faults& faults) const;
  bool operator==(const Basis&) const = default;
};

/// Camera: `location` with one of three spellings of what it sees:
/// - `look_at` or `direction`, `up`, and `fov_degrees` (orthographic: `height`);
/// - the slides' view plane: `direction` runs to the plane's centre, `up` and `right` from there to
///   its edges (orthographic: these are the picture's half extents);
/// - AlgoWiki's `basis` and a grid of squares of `pixel_size` at `distance` (orthographic: none).
/// Space/units: world space, scene units. Default: at the origin, looking along -z.
struct Camera {
  static constexpr std::string_view schema_name = "camera";
  Vec3d location{};
  std::optional<Vec3d> look_at, direction;
  Vec3d up{0, 1, 0};
  std::optional<Vec3d> right;
  double fov_degrees = 25;
  std::optional<Basis> basis;
  std::optional<double> distance, pixel_size;
  Projection projection = Projection::perspective;
  std::optional<double> height, angle_degrees;
  double aperture = 0;
  std::optional<double> focus_distance;
  std::optional<double> near, far;  ///< along the view's axis; none: all is seen
  std::optional<Display> display;   ///< none: one view
  std::optional<Interlace> interlace;

  template <class Visitor>
  static void fields(Visitor&& visit);
  /// Conflicting spellings, what a spelling lacks, zero lengths, an `up` along the view,
  /// planes in the wrong order, displays that do not fit.
  void check(const Place& at, Faults& faults) const;
  bool operator==(const Camera&) const = default;
};

/// The way from the eye to what it looks at; its length is of no meaning but to a view plane.
/// Domain: a camera whose spellings do not conflict.
Vec3d axis_of(const Camera& camera);

template <class Visitor>
void Camera::fields(Visitor&& visit) {
  constexpr double most = 1e9;
  const auto point = [](const char* about) {
    return Spec{.about = about, .min = -most, .max = most};
  };
  const auto size = [](const char* about) {
    return Spec{.about = about, .min = 0, .max = most, .open_min = true};
  };
  visit("location", &Camera::location, point("the eye"));
  visit("look_at", &Camera::look_at, point("the point in the picture's centre"));
  visit("direction", &Camera::direction,
        point("the way the eye looks; with right, up to the view plane's centre"));
  visit("up", &Camera::up, point("what is up; with right, half the view plane's height"));
  visit("right", &Camera::right, point("half the view plane's width"));
  visit("fov_degrees", &Camera::fov_degrees,
        Spec{.about = "vertical field of view",
             .unit = "degrees",
             .min = 0,
             .max = 179,
             .open_min = true});
  visit("basis", &Camera::basis,
        Spec{.about = "the camera's own axes, instead of look_at, direction, up and right"});
  visit("distance", &Camera::distance, size("with basis: from the eye to the grid of pixels"));
  visit("pixel_size", &Camera::pixel_size, size("with basis: the side of a pixel's square"));
  visit("projection", &Camera::projection,
        Spec{.about = "rays from the eye through a plane, or parallel ones from the plane of "
                      "location; or from the eye by angles: a disc of the sphere, all around, or a "
                      "cylinder"});
  visit("height", &Camera::height,
        size("orthographic: the whole picture's height; cylindrical: on the cylinder of radius 1, "
             "else such that pixels are squares"));
  visit("angle_degrees", &Camera::angle_degrees,
        Spec{.about = "fisheye: seen across the shorter side, else 180; cylindrical: across the "
                      "width, else 360",
             .unit = "degrees",
             .min = 0,
             .max = 360,
             .open_min = true});
  visit("aperture", &Camera::aperture,
        Spec{.about = "the lens' diameter; 0 is a pinhole, all sharp", .min = 0, .max = most});
  visit("focus_distance", &Camera::focus_distance,
        size("from the eye along the view to the plane that is sharp"));
  visit("near", &Camera::near,
        size("along the view's axis: what is nearer to the eye is not seen, but for its shadow"));
  visit("far", &Camera::far,
        size("along the view's axis: what is farther from the eye is not seen, but for its light"));
  visit("display", &Camera::display,
        Spec{.about = "what several views are made for; width and height are then of one view"});
  visit("interlace", &Camera::interlace,
        Spec{.about = "of a quilt: its views woven together for a panel or a sheet of lenses"});
}

}  // namespace tia
