// World: the compiled, immutable scene that every thread shares: geometry, and what lights it.
#pragma once

#include <array>
#include <vector>

#include "core/accel/world/geometry.h"
#include "core/scene/beam.h"

namespace tia {

/// World. Moving a light or the camera leaves the objects' geometry as it is, so that worlds share
/// it; what luminous lights add is little, and has an index of its own.
/// Space/units: world space is the scene's, seen from `origin`, which is taken off in double before
/// anything is rounded to float. It is 0 where the objects are not far from the scene's origin.
struct World {
  SharedGeometry of_objects;
  Vec3d origin{};      ///< in the scene's coordinates: of_objects->origin
  Geometry of_lights;  ///< the surfaces of luminous lights; their primitives follow the objects'
  std::vector<WorldLight> lights;
  /// Where few_balls: all of them, a primitive each, in order.
  std::vector<Ball> balls;
  Constant background;
  int objects = 0;                   ///< how many; the luminous lights are the last
  bool transparent_shadows = false;  ///< whether light goes straight through what transmits
  bool few_balls = false;      ///< so few, plain and lit from points, that they are tried in turn
  std::size_t degenerate = 0;  ///< triangles without area, which nothing meets

  /// All that rays can meet, in the order of the primitives.
  std::array<const Geometry*, 2> geometries() const { return {of_objects.get(), &of_lights}; }
  /// The one that a primitive is of.
  const Geometry& geometry_of(int primitive) const {
    return primitive < of_lights.first_primitive ? *of_objects : of_lights;
  }
  const Primitive& primitive(int i) const { return geometry_of(i).primitive(i); }
  const ShadingParameters& shading_of(int i) const { return geometry_of(i).shading_of(i); }
};

/// Domain: a scene that read_scene has passed. Errors: Stopped once that is asked for.
World compile(const Scene& scene, const Workers& workers = {});
/// The same of objects that are compiled already. Domain: geometry_of(scene), or that of a scene
/// with the same objects, materials and ambient light.
/// Cost: O(lights + luminous balls).
World compile(const Scene& scene, SharedGeometry objects, const Workers& workers = {});

/// The balls that rays of a beam may meet, in the scene's order. Domain: world.few_balls.
std::vector<int> candidates(const World& world, const Beam& beam);

}  // namespace tia
