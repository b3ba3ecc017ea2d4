// Geometry + lights -> World.
#include <algorithm>
#include <optional>

#include "core/accel/world/geometry_builder.h"
#include "core/accel/world/world.h"

namespace tia {
namespace {

// ---- few balls --------------------------------------------------------------------------------

constexpr std::size_t few_balls = 16;
// With more lights a ray takes so long that its work has to be counted, which FewBallsView does not
// do.
constexpr std::size_t few_lights = 64;

// Whether it shines from one point and does not fade.
bool is_plain_point(const WorldLight& light) {
  const bool from_point =
      std::visit([]<class Form>(const Form&) { return ShinesFromPoint<Form>; }, light.form);
  return from_point && light.fade_distance == 0 && light.samples == 1;
}

// Whether the surface has a diffuse term alone.
bool is_plain(const ShadingParameters& shading) {
  return !emits(shading.ambient.exact) && shading.brilliance == 1 && shading.specular == 0 &&
         shading.reflection == 0 && shading.transmission == 0 && shading.texture < 0 &&
         shading.form < 0 && !shading.see_through && !shading.one_sided;
}

bool is_plain_balls(const Geometry& geometry) {
  return geometry.balls.size() == geometry.primitives.size() && geometry.grids.empty() &&
         geometry.balls.size() <= few_balls && std::ranges::all_of(geometry.shadings, is_plain);
}

// Lists the balls of a world that FewBallsView can draw; of another none.
void list_few_balls(World& world) {
  std::vector<Ball> all;
  for (const Geometry* each : world.geometries()) {
    if (!is_plain_balls(*each)) return;
    all.insert(all.end(), each->balls.begin(), each->balls.end());
  }
  world.few_balls = all.size() <= few_balls && world.lights.size() <= few_lights &&
                    world.skies.empty() && !world.backdrop &&
                    std::ranges::all_of(world.lights, is_plain_point);
  if (world.few_balls) world.balls = std::move(all);
}

// ---- lights -----------------------------------------------------------------------------------

class Lighting {
 public:
  Lighting(const Scene& scene, SharedGeometry objects, const Workers& workers)
      : scene_(scene), workers_(workers) {
    world_.background = rgb_of(scene.background);
    world_.backdrop = scene.backdrop;
    world_.transparent_shadows = scene.options.transparent_shadows;
    world_.lights = objects->lights;
    world_.origin = objects->origin;
    world_.passable = objects->passable;
    world_.see_through = objects->see_through;
    lights_.first_primitive = static_cast<int>(objects->primitives.size());
    lights_.objects = objects->objects;
    world_.of_objects = std::move(objects);
  }

  // On a floor, where there is one.
  World lit(const Plane* floor = nullptr) {
    add_lights();
    if (floor != nullptr) world_.floor = add_floor(*floor);
    if (scene_.fog) world_.fog = fog_of(*scene_.fog);
    builder_.finish();
    world_.objects = lights_.objects;
    world_.degenerate = world_.of_objects->degenerate + lights_.degenerate;
    world_.path_lights = PathLights(world_.lights, world_.of_objects->areas, world_.skies.size());
    list_few_balls(world_);
    return std::move(world_);
  }

 private:
  void add_lights() {
    for (std::size_t i = 0; i < scene_.lights.size(); ++i)
      add(scene_.lights[i], "/lights/" + std::to_string(i));
    if (scene_.key_light) add(*scene_.key_light, "/key_light");
    if (skies_) world_.background = *skies_;
  }
  void add(const Light& light, const std::string& name) {
    if (light.awaited() != nullptr) return;  // a key light whose key has not been pressed
    const Vec3d color = rgb_of(light.color) * light.intensity;
    std::visit(
        [&]<class Kind>(const Kind& kind) {
          if constexpr (BackgroundLight<Kind>) skies_ = skies_.value_or(Vec3d{}) + color;
          if constexpr (PaintsSky<Kind>) add_sky(sky_of(kind), color, name);
          if constexpr (HasTint<Kind>) add_shining(kind, light, color * tint(kind), name);
          else if constexpr (ShiningLight<Kind>) add_shining(kind, light, color, name);
        },
        light.kind);
  }
  WorldFog fog_of(const Fog& fog) const {
    WorldFog own{fog.density, fog.g, rgb_of(fog.albedo), {}};
    if (fog.bounds) {
      Bounds bounds = *fog.bounds;
      for (auto* corner : {&bounds.min, &bounds.max, &bounds.center})
        if (*corner) *corner = **corner - world_.origin;
      own.region = prepare(bounds);
    }
    return own;
  }
  void add_sky(SkyForm form, const Vec3d& color, const std::string& name) {
    skies_ = skies_.value_or(Vec3d{});
    if (emits(color)) world_.skies.push_back({std::move(form), color, name});
  }
  template <ShiningLight Kind>
  void add_shining(Kind kind, const Light& light, const Vec3d& color, const std::string& name) {
    kind.move_by(-world_.origin);
    const auto form = prepare(kind);
    WorldLight shining{form, {}, color};
    if constexpr (ShinesFromPoint<FormOf<Kind>>) shining.middle = form.middle;
    if (light.fade_distance) shining.fade_distance = *light.fade_distance;
    shining.fade_power = light.fade_power;
    shining.name = name;
    if constexpr (AreaLight<Kind>) shining.samples = kind.samples;
    if constexpr (SeenLight<Kind>) shining.primitive = add_seen(surface(kind), color);
    if (emits(color)) world_.lights.push_back(shining);
  }
  // Returns: its primitive.
  template <IsSeenSurface S>
  int add_seen(const S& shape, const Vec3d& color) {
    ShadingParameters glow;
    glow.emission = color;
    const Setting own{Affine{}, pushed(lights_.shadings, glow), 0, false};
    if constexpr (IsSurface<S>) return builder_.add(prepare(shape), own);
    else return builder_.add(indexed(shape, workers_), own);
  }

  int add_floor(const Plane& floor) {
    Finish white;
    white.ambient = 1;
    const ShadingParameters shading = shading_of(white, rgb_of(scene_.ambient_light));
    return builder_.add(prepare(floor), {Affine{}, pushed(lights_.shadings, shading), 0, false});
  }

  const Scene& scene_;
  const Workers& workers_;
  World world_;
  Geometry& lights_ = world_.of_lights;
  GeometryBuilder builder_{lights_, workers_};
  std::optional<Vec3d> skies_;  // the sum of the sky lights; none: the scene's background
                                // is seen
};

// The camera's rays end at the floor: they come from just before it, and no backdrop is theirs.
World on_floor(const Scene& scene, SharedGeometry objects, const Plane& floor,
               const Workers& workers) {
  World world = Lighting(scene, std::move(objects), workers).lit(&floor);
  world.backdrop.reset();
  return world;
}

// What is computed without the objects must be, to the bit, what is computed where they are far.
WorldGround ground_of(const Scene& scene, const SharedGeometry& objects, const Workers& workers) {
  Geometry none = geometry_of({}, workers);
  none.origin = objects->origin;
  none.passable = objects->passable;
  none.see_through = objects->see_through;
  Plane plane = scene.shadow_ground->plane();
  plane.point = plane.point - objects->origin;
  return {prepare(plane), on_floor(scene, objects, plane, workers),
          on_floor(scene, std::make_shared<const Geometry>(std::move(none)), plane, workers)};
}

}  // namespace

World compile(const Scene& scene, SharedGeometry objects, const Workers& workers) {
  World world = Lighting(scene, objects, workers).lit();
  if (scene.shadow_ground)
    world.ground = std::make_shared<const WorldGround>(ground_of(scene, objects, workers));
  return world;
}

World compile(const Scene& scene, const Workers& workers) {
  return compile(scene, std::make_shared<const Geometry>(geometry_of(scene, workers)), workers);
}

std::vector<int> candidates(const World& world, const Beam& beam) {
  std::vector<int> found;
  for (std::size_t i = 0; i < world.balls.size(); ++i)
    if (beam.may_meet(world.balls[i].sphere.center, world.balls[i].sphere.radius))
      found.push_back(static_cast<int>(i));
  return found;
}

}  // namespace tia
