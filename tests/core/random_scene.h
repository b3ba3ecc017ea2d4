// Random scenes for the laws that every scene obeys.
#pragma once

#include "tests/core/support.h"

namespace tia::test {

inline Color random_color(Random& random) {
  const double r = random.unit(), g = random.unit();
  return {r, g, random.unit()};
}

/// A number 0 .. 1, the same everywhere or by a texture of any kind that needs no surface
/// coordinates.
inline NumberOrTexture random_share(Random& random) {
  if (random.chance(0.7)) return random.unit();
  NumberTexture texture;
  switch (random.below(3)) {
    case 0: texture.kind = OfNumbers<Checker>{}; break;
    case 1: texture.kind = OfNumbers<Noise>{}; break;
    default: texture.kind = OfNumbers<Marble>{}; break;
  }
  const double black = random.unit();
  texture.range = {black, random.unit()};
  return texture;
}
/// A physical material of any kind.
inline Principled random_principled(Random& random) {
  Principled p;
  p.base_color = random_color(random);
  p.sheen_color = random.chance(0.3) ? random_color(random) : Color{};
  p.thin = random.chance(0.2);
  for (const auto number :
       {&Principled::metallic, &Principled::roughness, &Principled::specular,
        &Principled::transmission, &Principled::clearcoat, &Principled::clearcoat_roughness,
        &Principled::sheen_roughness, &Principled::anisotropy})
    p.*number = random_share(random);
  return p;
}

/// A camera near the origin that looks roughly along -z, spelled in one of the four ways.
inline Camera random_camera(Random& random) {
  Camera camera;
  camera.location = random.point(2);
  const Vec3d way{random.in(-0.3, 0.3), random.in(-0.3, 0.3), -1};
  camera.up = {random.in(-0.3, 0.3), 1, random.in(-0.2, 0.2)};
  switch (random.below(4)) {
    case 0: camera.look_at = camera.location + way * 20.0; break;
    case 1: camera.direction = way * random.in(0.1, 10); break;
    case 2:
      camera.direction = way;
      camera.right = Vec3d{random.in(0.2, 0.8), random.in(-0.1, 0.1), random.in(-0.1, 0.1)};
      camera.up = camera.up * random.in(0.2, 0.6);
      return camera;
    default: break;
  }
  camera.fov_degrees = random.in(15, 70);
  return camera;
}

/// Up to `most` balls before the camera, some of them luminous, a floor, lights of both kinds.
inline Scene random_scene(std::uint64_t seed, int most = 8) {
  Random random(seed);
  Scene scene;
  scene.camera = random_camera(random);
  scene.background = random_color(random);
  const int balls = 1 + random.below(most);
  for (int i = 0; i < balls; ++i) {
    const Vec3d center = random.point(8) + Vec3d{0, 0, -22};
    const Color glow = random.chance(0.15) ? random_color(random) : Color{};
    const double radius = random.in(0.3, 3);
    scene.objects.push_back(ball(center, radius, matte(random_color(random), glow)));
  }
  if (random.chance(0.7))
    scene.objects.push_back(ball({0, -10010, -20}, 10000, matte(random_color(random))));
  const int lights = random.below(4);
  for (int i = 0; i < lights; ++i) {
    const Vec3d place = random.point(15) + Vec3d{0, 12, -15};
    const Color color = random_color(random);
    if (random.chance(0.5)) scene.lights.push_back(point_light(place, color));
    else scene.lights.push_back(sphere_light(place, random.in(0.2, 2), color));
  }
  const Vec3d place = random.point(10);
  if (random.chance(0.5)) scene.key_light = point_light(place, random_color(random));
  return scene;
}

}  // namespace tia::test
