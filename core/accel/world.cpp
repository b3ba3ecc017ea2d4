#include "core/accel/world.h"

namespace tia {
namespace {

Vec3d rgb(const Color& c) { return {c.r, c.g, c.b}; }

bool emits(const Vec3d& light) { return light.x > 0 || light.y > 0 || light.z > 0; }

Matte matte_of(const Material& material) {
  const auto& finish = std::get<Finish>(material.kind);
  return {rgb(finish.color) * finish.diffuse, rgb(finish.emission)};
}

Matte matte_of(const Object& object, const Scene& scene) {
  if (!object.material) return matte_of(Material{});
  const auto* name = std::get_if<std::string>(&*object.material);
  return matte_of(name != nullptr ? scene.materials.at(*name)
                                  : std::get<Material>(*object.material));
}

// A luminous ball is an object like any other, and a lamp at its centre.
void add(const Sphere& sphere, const Matte& matte, World& world) {
  const int object = static_cast<int>(world.spheres.size());
  world.spheres.push_back(sphere);
  world.mattes.push_back(matte);
  if (emits(matte.emission.exact)) world.lamps.push_back({sphere.center, matte.emission, object});
}

void add(const Light& light, World& world) {
  if (!light.position()) return;  // a key light that no key has lit yet
  const Vec3d color = rgb(light.color) * light.intensity;
  if (const auto* ball = std::get_if<SphereLight>(&light.kind))
    add(Sphere{*ball->position, ball->radius}, Matte{{}, color}, world);
  else if (emits(color)) world.lamps.push_back({*light.position(), color});
}

}  // namespace

World compile(const Scene& scene) {
  World world;
  world.background = rgb(scene.background);
  for (const Object& object : scene.objects)
    add(std::get<Sphere>(object.shape), matte_of(object, scene), world);
  for (const Light& light : scene.lights) add(light, world);
  if (scene.key_light) add(*scene.key_light, world);
  return world;
}

std::vector<int> candidates(const World& world, const Beam& beam) {
  std::vector<int> found;
  for (std::size_t i = 0; i < world.spheres.size(); ++i)
    if (beam.may_meet(world.spheres[i].center, world.spheres[i].radius))
      found.push_back(static_cast<int>(i));
  return found;
}

}  // namespace tia
