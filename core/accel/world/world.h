// World: the compiled, immutable scene that every thread shares: geometry, and what lights it.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core/accel/world/geometry.h"
#include "core/scene/beam.h"
#include "core/shapes/bounds.h"

namespace tia {

/// WorldSky: light by direction, times a colour.
struct WorldSky {
  SkyForm form;
  Constant color;
  std::string name;  ///< the JSON Pointer of its light
};

/// WorldFog: what scatters light in a region, or in all space. `density` 0: none.
/// Space/units: world space, scene units.
struct WorldFog {
  double density = 0, g = 0;
  Constant albedo;
  std::optional<Region> region;
};

struct WorldGround;

/// World. The geometry of the objects does not depend on lights and camera, so worlds that differ
/// in these share it. The surfaces of lights are a small geometry beside it, with an index of its
/// own. Space/units: world space is the scene's less `origin`, which is subtracted in double before
/// anything is rounded to float. It is 0 where the objects are near the scene's origin.
struct World {
  SharedGeometry of_objects;
  Vec3d origin{};      ///< in the scene's coordinates: of_objects->origin
  Geometry of_lights;  ///< the surfaces of luminous lights; their primitives follow the objects'
  std::vector<WorldLight> lights;
  PathLights path_lights;  ///< for the path tracer in their place
  /// If few_balls: all balls, one for each primitive, in order. Else none.
  std::vector<Ball> balls;
  Constant background;
  std::optional<Backdrop> backdrop;           ///< what camera rays find that meet no object
  std::shared_ptr<const WorldGround> ground;  ///< before the backdrop; null: none
  std::vector<WorldSky> skies;                ///< are seen where rays leave, beside the background
  WorldFog fog;
  int objects = 0;  ///< how many; the luminous lights are the last
  bool transparent_shadows =
      false;                 ///< whether shadow rays pass through transmitting objects, unbent
  bool passable = false;     ///< whether rays may go straight through some surfaces (Sight)
  bool see_through = false;  ///< whether shadow rays may, too, which back faces stop
  bool few_balls = false;    ///< whether FewBallsView can draw it
  int floor = -1;  ///< the primitive that scatters light to the camera alone; -1: none does
  std::size_t degenerate = 0;  ///< triangles without area, which no ray hits

  /// All that rays can hit, in the order of the primitives' numbers.
  std::array<const Geometry*, 2> geometries() const { return {of_objects.get(), &of_lights}; }
  /// The geometry that a primitive belongs to.
  const Geometry& geometry_of(int primitive) const {
    return primitive < of_lights.first_primitive ? *of_objects : of_lights;
  }
  const Primitive& primitive(int i) const { return geometry_of(i).primitive(i); }
  const ShadingParameters& shading_of(int i) const { return geometry_of(i).shading_of(i); }
};

/// WorldGround: a plane on which shadows are seen: what it sends back if it is a floor, white to
/// the camera and black to all else, with the objects of its world on it and without any. Both
/// worlds have the same lights. Space/units: the world's.
struct WorldGround {
  PlaneForm plane;
  World with, without;
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
