#include "core/scene/views.h"

#include "core/math/deterministic.h"

namespace tia {
namespace {

// What a spelling gives: the view but for its size, and the lens' axes.
struct SpelledCamera {
  Vec3d forward, right, up;
  Vec3d across, upwards;  // unit, perpendicular, in the plane of right and up
};

// At distance 1 before the eye, lest a plane of 1e-30 vanish from float.
SpelledCamera of_view_plane(const Camera& camera) {
  const Vec3d forward = axis_of(camera);
  const double near = 1 / length(forward);
  const double scale = camera.projection == Projection::orthographic ? 1 : near;
  const Vec3d across = normalize(*camera.right);  // the lens is round, also where they are skew
  const Vec3d upwards = normalize(camera.up - across * dot(across, camera.up));
  return {forward * near, *camera.right * scale, camera.up * scale, across, upwards};
}

// Source: AlgoWiki's ray tracing article; pixel (i, j) from the bottom left looks along
// (s (j - w/2 + 1/2), s (i - h/2 + 1/2), -d) in the basis.
SpelledCamera of_grid(const Camera& camera, int width, int height) {
  const Basis& basis = *camera.basis;
  if (!row_of(camera.projection).is_flat) return {-basis.w, basis.u, basis.v, basis.u, basis.v};
  const double side = *camera.pixel_size / camera.distance.value_or(1);
  return {normalize(-basis.w), basis.u * (side * width / 2), basis.v * (side * height / 2), basis.u,
          basis.v};
}

SpelledCamera of_angle(const Camera& camera, int width, int height) {
  const Vec3d w = normalize(axis_of(camera));
  const Vec3d u = normalize(cross(w, camera.up));
  const Vec3d v = cross(u, w);
  if (!row_of(camera.projection).is_flat) return {w, u, v, u, v};
  const double half_height = camera.projection == Projection::orthographic
                                 ? *camera.height / 2
                                 : tan_of(camera.fov_degrees / 2 * (pi / 180));
  const double half_width = half_height * static_cast<double>(width) / static_cast<double>(height);
  return {w, u * half_width, v * half_height, u, v};
}

SpelledCamera spelled_by(const Camera& camera, int width, int height) {
  return camera.right   ? of_view_plane(camera)
         : camera.basis ? of_grid(camera, width, height)
                        : of_angle(camera, width, height);
}

// The picture's plane may be skew to the way to its centre.
Vec3d axis_across(const SpelledCamera& spelled) {
  const Vec3d axis = cross(spelled.upwards, spelled.across);
  return dot(axis, spelled.forward) < 0 ? -axis : axis;
}

}  // namespace

View view_of(const Camera& camera, int width, int height) {
  const SpelledCamera spelled = spelled_by(camera, width, height);
  View view{camera.location, spelled.forward, spelled.right,    spelled.up,
            width,           height,          camera.projection};
  view.lens_right = spelled.across * (camera.aperture / 2);
  view.lens_up = spelled.upwards * (camera.aperture / 2);
  view.focus_distance = camera.focus_distance.value_or(1);
  view.axis = axis_across(spelled);
  view.near = camera.near.value_or(view.near);
  view.far = camera.far.value_or(view.far);
  const ProjectionRow& row = row_of(camera.projection);
  if (row.make != nullptr)
    view.curved =
        row.make({camera.angle_degrees.value_or(row.usual_angle) * (pi / 180), camera.height,
                  static_cast<double>(width), static_cast<double>(height)});
  return view;
}

ViewGrid views_of(const Camera& camera, int width, int height) {
  const View view = view_of(camera, width, height);
  if (!camera.display) return {1, 1, {{view, 0, 0, "view"}}};
  const SpelledCamera spelled = spelled_by(camera, width, height);
  const DisplayFrame frame{view, spelled.across, spelled.upwards, camera.look_at};
  if (camera.interlace) return camera.display->quilt()->interlaced(frame, *camera.interlace);
  return std::visit([&](const auto& kind) { return kind.grid(frame); }, camera.display->kind);
}

}  // namespace tia
