// Geometry + lights -> World.
#include <algorithm>
#include <map>

#include "core/accel/world/geometry_builder.h"
#include "core/accel/world/world.h"

namespace tia {
namespace {

// ---- few balls --------------------------------------------------------------------------------

constexpr std::size_t few_balls = 16;
// Beyond so many lights a ray takes so long that its work has to be counted, which this way does
// not.
constexpr std::size_t few_lights = 64;

// A point as seen from anywhere, whose light does not fade.
bool is_plain_point(const Lamp& lamp) {
  const bool point =
      std::holds_alternative<PointForm>(lamp.form) || std::holds_alternative<SphereForm>(lamp.form);
  return point && lamp.fade_distance == 0 && lamp.places == nullptr;
}

// Whether it scatters light and does nothing else.
bool is_plain(const Matter& matter) {
  return !emits(matter.ambient.exact) && matter.brilliance == 1 && matter.specular == 0 &&
         matter.reflection == 0 && matter.transmission == 0 && matter.texture < 0;
}

bool is_plain_balls(const Geometry& geometry) {
  return geometry.balls.size() == geometry.parts.size() && geometry.copies.empty() &&
         geometry.balls.size() <= few_balls && std::ranges::all_of(geometry.matters, is_plain);
}

// Lists all balls, if they are so few and plain that they are tried in turn.
void list_few_balls(World& world) {
  std::vector<Ball> all;
  for (const Geometry* each : world.geometries()) {
    if (!is_plain_balls(*each)) return;
    all.insert(all.end(), each->balls.begin(), each->balls.end());
  }
  world.few_balls = all.size() <= few_balls && world.lamps.size() <= few_lights &&
                    std::ranges::all_of(world.lamps, is_plain_point);
  if (world.few_balls) world.balls = std::move(all);
}

// ---- lights -----------------------------------------------------------------------------------

class Lighting {
 public:
  Lighting(const Scene& scene, SharedGeometry objects, const Workers& workers)
      : scene_(scene), workers_(workers) {
    world_.background = rgb_of(scene.background);
    world_.transparent_shadows = scene.options.transparent_shadows;
    world_.lamps = objects->lamps;
    lights_.first_part = static_cast<int>(objects->parts.size());
    lights_.objects = objects->objects;
    world_.of_objects = std::move(objects);
  }

  World lit() {
    add_lights();
    builder_.finish();
    world_.objects = lights_.objects;
    world_.degenerate = world_.of_objects->degenerate + lights_.degenerate;
    list_few_balls(world_);
    return std::move(world_);
  }

 private:
  void add_lights() {
    Vec3d skies{};
    bool sky = false;
    const auto add = [&](const Light& light, const std::string& name) {
      if (light.awaited() != nullptr) return;  // a key light that no key has lit yet
      const Vec3d color = rgb_of(light.color) * light.intensity;
      if (std::holds_alternative<SkyLight>(light.kind)) {
        skies = skies + color;
        sky = true;
      }
      std::visit([&](const auto& kind) { add_light(kind, light, color, name); }, light.kind);
    };
    for (std::size_t i = 0; i < scene_.lights.size(); ++i)
      add(scene_.lights[i], "/lights/" + std::to_string(i));
    if (scene_.key_light) add(*scene_.key_light, "/key_light");
    if (sky) world_.background = skies;
  }
  template <class Kind>
  void add_light(const Kind& kind, const Light& light, const Vec3d& color,
                 const std::string& name) {
    if constexpr (MovableLight<Kind>) {
      Lamp lamp{prepare(kind), light.place().value_or(Vec3d{}), color};
      if (light.fade_distance) lamp.fade_distance = *light.fade_distance;
      lamp.fade_power = light.fade_power;
      lamp.name = name;
      if constexpr (requires { kind.samples; }) {
        lamp.places = places(kind.samples);
        lamp.part = lights_.first_part + static_cast<int>(lights_.parts.size());
        Matter glow;
        glow.emission = color;
        add_luminous(kind, {Affine{}, pushed(lights_.matters, glow), 0, false});
      }
      if (emits(color)) world_.lamps.push_back(lamp);
    }
  }
  std::shared_ptr<const Strata> places(int samples) {
    if (samples == 1) return nullptr;
    std::shared_ptr<const Strata>& shared = strata_[samples];
    if (!shared) shared = std::make_shared<const Strata>(samples);
    return shared;
  }
  void add_luminous(const SphereLight& light, const Setting& own) {
    builder_.add(Sphere{*light.position, light.radius}, own);
  }
  void add_luminous(const QuadLight& light, const Setting& own) {
    Mesh mesh;
    const Vec3d corners[] = {*light.corner, *light.corner + light.u,
                             *light.corner + light.u + light.v, *light.corner + light.v};
    for (const Vec3d& p : corners)
      mesh.positions.values.insert(mesh.positions.values.end(), {p.x, p.y, p.z});
    mesh.indices.values = {0, 1, 2, 0, 2, 3};
    builder_.add(indexed(mesh, workers_), own);
  }

  const Scene& scene_;
  const Workers& workers_;
  World world_;
  Geometry& lights_ = world_.of_lights;
  GeometryBuilder builder_{lights_, workers_};
  std::map<int, std::shared_ptr<const Strata>> strata_;
};

}  // namespace

World compile(const Scene& scene, SharedGeometry objects, const Workers& workers) {
  return Lighting(scene, std::move(objects), workers).lit();
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
