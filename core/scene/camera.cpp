#include "core/scene/camera.h"

#include <algorithm>
#include <cmath>

#include "core/input/codec.h"

namespace tia {
namespace {

// The sine of the least angle between axes: with less, rounding would turn the axis that is made
// perpendicular to them by more than 1e-7, float's own rounding.
constexpr double parallel = 1e-9;
// The greatest extent of the view, per unit of the eye's distance from it: the inverse of the same.
constexpr double widest = 1e9;

// |a x b| as a share of |a| |b|: 0 where the two are parallel or one is zero.
double sine_between(const Vec3d& a, const Vec3d& b) {
  const double lengths = length(a) * length(b);
  return lengths > 0 ? length(cross(a, b)) / lengths : 0;
}

// Collects one camera's faults.
class Check {
 public:
  Check(const Camera& camera, const Place& at, Faults& faults)
      : camera_(camera), at_(at), faults_(faults) {}

  void all() {
    const std::size_t before = faults_.count();
    spellings();
    if (camera_.basis) grid();
    projection();
    lens();
    planes();
    display();
    interlace();
    if (faults_.count() != before) return;
    if (camera_.basis) grid_extent();
    else axes();
    if (camera_.aperture > widest * camera_.focus_distance.value_or(1))
      fault(FaultKind::out_of_range, "focus_distance", *camera_.focus_distance,
            "at least 1e-9 of aperture");
  }

 private:
  void spellings();
  void grid();
  void projection();
  void lens();
  void planes();
  void display();
  void interlace();
  void grid_extent();
  void axes();
  void view_plane();

  bool orthographic() const { return camera_.projection == Projection::orthographic; }
  const ProjectionRow& row() const { return row_of(camera_.projection); }
  bool has_own_fov() const { return camera_.fov_degrees != Camera{}.fov_degrees; }
  void fault(FaultKind kind, const char* field, std::optional<Value> got, const char* allowed) {
    faults_.add({kind, at_.at(field).pointer(), std::move(got), allowed});
  }
  template <class T>
  void refuse(const char* field, const std::optional<T>& value, const char* allowed) {
    if (value) fault(FaultKind::conflict, field, write_value(*value), allowed);
  }
  void require(const char* field, const std::optional<double>& value, const char* about) {
    if (!value) fault(FaultKind::missing, field, std::nullopt, about);
  }

  const Camera& camera_;
  const Place& at_;
  Faults& faults_;
};

void Check::spellings() {
  const Camera& c = camera_;
  if (c.basis) {
    constexpr auto alone = "basis goes without look_at, direction, up, right and fov_degrees";
    refuse("look_at", c.look_at, alone);
    refuse("direction", c.direction, alone);
    if (c.up != Camera{}.up) fault(FaultKind::conflict, "up", write_value(c.up), alone);
    refuse("right", c.right, alone);
    if (has_own_fov()) fault(FaultKind::conflict, "fov_degrees", c.fov_degrees, alone);
    return;
  }
  if (c.look_at) refuse("direction", c.direction, "look_at or direction");
  if (c.right) {
    refuse("look_at", c.look_at, "right goes with direction and up (the view plane)");
    if (has_own_fov())
      fault(FaultKind::conflict, "fov_degrees", c.fov_degrees,
            "right goes without fov_degrees: the view plane's size is the angle");
  }
  refuse("distance", c.distance, "distance goes with basis");
  refuse("pixel_size", c.pixel_size, "pixel_size goes with basis");
}

void Check::grid() {
  if (!row().is_flat) {
    constexpr auto alone = "a basis by angles goes without pixel_size and distance";
    refuse("pixel_size", camera_.pixel_size, alone);
    return refuse("distance", camera_.distance, alone);
  }
  require("pixel_size", camera_.pixel_size, "the side of a pixel's square, for basis");
  if (orthographic())
    refuse("distance", camera_.distance, "an orthographic basis goes without distance");
  else require("distance", camera_.distance, "from the eye to the grid of pixels, for basis");
}

void Check::projection() {
  const Camera& c = camera_;
  if (!row().takes_angle)
    refuse("angle_degrees", c.angle_degrees,
           "angle_degrees goes with projection fisheye or cylindrical");
  if (!row().takes_height)
    refuse("height", c.height, "height goes with projection orthographic or cylindrical");
  if (!row().is_flat)
    refuse("right", c.right, "a view plane goes with projection perspective or orthographic");
  if (!row().takes_fov && has_own_fov() && !c.basis && !c.right)
    fault(FaultKind::conflict, "fov_degrees", c.fov_degrees,
          orthographic() ? "projection orthographic goes with height, without fov_degrees"
                         : "fov_degrees goes with projection perspective");
  if (!orthographic()) return;
  if (c.basis)
    return refuse("height", c.height, "basis goes without height: pixel_size gives the extent");
  if (c.right)
    return refuse("height", c.height, "right goes without height: the view plane is the extent");
  require("height", c.height, "the whole picture's height, for projection orthographic");
}

void Check::lens() {
  const Camera& c = camera_;
  constexpr auto allowed = "only projection perspective has a lens";
  if (!row().has_lens) {
    if (c.aperture > 0) fault(FaultKind::conflict, "aperture", c.aperture, allowed);
    refuse("focus_distance", c.focus_distance, allowed);
  } else if (c.aperture > 0) {
    require("focus_distance", c.focus_distance,
            "from the eye along the view to the plane that is sharp, for aperture");
  }
}

void Check::planes() {
  if (!row().is_flat) {
    constexpr auto allowed = "near and far go with projection perspective or orthographic";
    refuse("near", camera_.near, allowed);
    return refuse("far", camera_.far, allowed);
  }
  if (camera_.near && camera_.far && !(*camera_.near < *camera_.far))
    fault(FaultKind::out_of_range, "far", *camera_.far, "more than near");
}

// What a display says itself, the camera must not say otherwise.
void Check::display() {
  const Camera& c = camera_;
  if (!c.display) return;
  const DisplayNeeds needs = c.display->needs();
  const bool fits = c.projection == Projection::perspective ||
                    (needs.orthographic && orthographic()) ||
                    (needs.panorama && c.projection == Projection::equirectangular);
  if (!fits)
    fault(FaultKind::conflict, "projection", Value(row().text),
          needs.orthographic ? "perspective or orthographic, of which such a display may be"
          : needs.panorama   ? "perspective or equirectangular, of which such a display is anyhow"
                             : "perspective, of which such a display is");
  if (!needs.lens && c.aperture > 0)
    fault(FaultKind::conflict, "aperture", c.aperture, "a display of such rays has no lens");
  if (needs.own_extent) {
    constexpr auto allowed = "such a display says itself how much its views see";
    refuse("right", c.right, allowed);
    refuse("pixel_size", c.pixel_size, allowed);
    refuse("near", c.near, allowed);
    refuse("far", c.far, allowed);
    if (has_own_fov()) fault(FaultKind::conflict, "fov_degrees", c.fov_degrees, allowed);
  }
  if (needs.look_at && !c.look_at)
    fault(FaultKind::missing, "look_at", std::nullopt, "the middle of the display's window");
  if (const char* focus = c.display->missing_focus(); focus != nullptr && !c.look_at)
    faults_.add({FaultKind::missing, at_.at("display").at(focus).pointer(), std::nullopt,
                 "a distance above 0, where the camera has no look_at"});
}

// Its rays are made one by one, of a window before the eye.
void Check::interlace() {
  const Camera& c = camera_;
  if (!c.interlace) return;
  const auto wrong = [&](const char* allowed) {
    fault(FaultKind::conflict, "interlace", write_value(*c.interlace), allowed);
  };
  if (!c.display || c.display->quilt() == nullptr) wrong("interlace goes with a display quilt");
  else if (c.projection != Projection::perspective || c.right || c.aperture > 0 || c.near || c.far)
    wrong("interlace goes with a perspective camera without right, lens, near and far");
}

// Pictures have up to 2^24 pixels, all perhaps in one row.
void Check::grid_extent() {
  constexpr double most = 100;
  if (row().takes_fov && *camera_.pixel_size > most * *camera_.distance)
    fault(FaultKind::out_of_range, "distance", *camera_.distance, "at least 0.01 of pixel_size");
}

void Check::axes() {
  const Camera& c = camera_;
  const Vec3d view = axis_of(c);
  if (length(view) == 0)
    fault(FaultKind::out_of_range, c.look_at ? "look_at" : "direction",
          write_value(c.look_at ? *c.look_at : view),
          c.look_at ? "a point other than location" : "a direction of some length");
  else if (sine_between(view, c.up) < parallel)
    fault(FaultKind::out_of_range, "up", write_value(c.up), "not zero, not parallel to the view");
  else if (c.right) view_plane();
}

void Check::view_plane() {
  const Vec3d view = axis_of(camera_), &right = *camera_.right, &up = camera_.up;
  if (length(right) == 0 ||
      std::fabs(dot(view, cross(right, up))) < parallel * length(view) * length(right) * length(up))
    fault(FaultKind::out_of_range, "right", write_value(right),
          "a view plane of some size that the eye does not lie in");
  else if (!orthographic() && std::max(length(right), length(up)) > widest * length(view))
    fault(FaultKind::out_of_range, "direction", write_value(view),
          "at least 1e-9 of the view plane's size: so far from the eye it is");
}

}  // namespace

void Basis::check(const Place& at, Faults& faults) const {
  constexpr double tolerance =
      1e-6;  // more than vectors are off that are written with seven digits
  const std::size_t before = faults.count();
  const auto fault = [&](const char* field, const Vec3d& got, const char* allowed) {
    faults.add({FaultKind::out_of_range, at.at(field).pointer(), write_value(got), allowed});
  };
  const auto near = [](double a, double b) { return std::fabs(a - b) <= tolerance; };
  const auto unit = [&](const char* field, const Vec3d& axis) {
    if (!near(length(axis), 1)) fault(field, axis, "a vector of length 1, to 1e-6");
  };
  unit("u", u);
  unit("v", v);
  unit("w", w);
  if (faults.count() != before) return;
  if (!near(dot(u, v), 0)) fault("v", v, "perpendicular to u, to 1e-6");
  else if (!near(dot(u, w), 0) || !near(dot(v, w), 0))
    fault("w", w, "perpendicular to u and v, to 1e-6");
  else if (dot(cross(u, v), w) < 0) fault("w", w, "u x v: the basis is right-handed");
}

void Camera::check(const Place& at, Faults& faults) const { Check(*this, at, faults).all(); }

Vec3d axis_of(const Camera& camera) {
  if (camera.basis) return -camera.basis->w;
  if (camera.look_at) return *camera.look_at - camera.location;
  return camera.direction.value_or(Vec3d{0, 0, -1});
}

}  // namespace tia
