// Scenes of surfaces that are there in part, or from one side.
#pragma once

#include "tests/core/tree.h"

namespace tia::test {

inline Object wearing_principled(const Shape& shape, const Principled& principled) {
  Object is;
  is.shape = shape;
  is.material = MaterialRef(Material{principled});
  return is;
}
/// What glows and scatters nothing, of that alpha.
inline Principled glowing(const Color& emissive, const NumberOrTexture& alpha = 1,
                          AlphaMode mode = AlphaMode::blend) {
  Principled p;
  p.base_color = Color{};
  p.specular = 0;
  p.emissive = emissive;
  p.alpha = alpha;
  p.alpha_mode = mode;
  return p;
}
inline NumberTexture checkered(double black, double white) {
  NumberTexture texture;
  texture.kind = OfNumbers<Checker>{};
  texture.range = {black, white};
  return texture;
}

/// Looks straight down at the plane y = 0, cells of 1 in a pixel each, from the middle.
inline constexpr int alpha_cells = 8;
inline Camera camera_above(double height) {
  Camera camera;
  camera.projection = Projection::orthographic;
  camera.height = alpha_cells;
  camera.location = {0, height, 0};
  camera.direction = Vec3d{0, -1, 0};
  camera.up = {0, 0, -1};
  return camera;
}
inline Image seen_by(const Scene& scene, IntegratorName integrator, int samples = 1,
                     int max_depth = 4) {
  RenderOptions options;
  options.integrator = integrator;
  options.samples = samples;
  options.max_depth = max_depth;
  return picture(scene, alpha_cells, alpha_cells, options).image;
}
inline Plane plane_at(double y) { return {{0, y, 0}, {0, 1, 0}}; }

}  // namespace tia::test
