// Scenes of all kinds of things, the same scenes somewhere else, and whether two scenes look alike.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/contract/formula_specimens.h"
#include "tests/core/accel/worlds.h"

namespace tia::test {

inline constexpr int far_width = 64, far_height = 48;

// ---- moving -----------------------------------------------------------------------------------

inline void shift(std::optional<Vec3d>& place, const Vec3d& by) {
  if (place) *place = *place + by;
}
inline Light moved(Light light, const Vec3d& by) {
  if (auto* spot = std::get_if<SpotLight>(&light.kind)) spot->point_at = spot->point_at + by;
  if (const auto place = light.place()) light.move_to(*place + by, {});
  return light;
}
inline Scene with_moved_view(Scene scene, const Vec3d& by) {
  scene.camera.location = scene.camera.location + by;
  shift(scene.camera.look_at, by);
  for (Light& light : scene.lights) light = moved(light, by);
  if (scene.key_light) scene.key_light = moved(*scene.key_light, by);
  return scene;
}
inline void translate(Object& object, const Vec3d& by) {
  object.transform.steps.push_back(Translate{by});
}

inline Scene moved(const Scene& scene, const Vec3d& by) {
  Scene far = with_moved_view(scene, by);
  for (Object& object : far.objects.edit()) translate(object, by);
  return far;
}

// By the numbers of the shape itself. Returns: whether it knows how.
inline bool move_numbers(Shape& shape, const Vec3d& by) {
  return std::visit(
      [&]<class Kind>(Kind& kind) {
        if constexpr (requires { kind.center = Vec3d{}; }) kind.center = kind.center + by;
        else if constexpr (requires { kind.point = Vec3d{}; }) kind.point = kind.point + by;
        else if constexpr (requires { kind.min = Vec3d{}; })
          kind.min = kind.min + by, kind.max = kind.max + by;
        else if constexpr (requires { kind.base; })
          kind.base = kind.base + by, kind.cap = kind.cap + by;
        else if constexpr (std::is_same_v<Kind, Triangle>)
          kind.a = kind.a + by, kind.b = kind.b + by, kind.c = kind.c + by;
        else if constexpr (std::is_same_v<Kind, Voxels>) kind.origin = kind.origin + by;
        else if constexpr (std::is_same_v<Kind, Mesh>) {
          const double each[] = {by.x, by.y, by.z};
          for (std::size_t i = 0; i < kind.positions.values.size(); ++i)
            kind.positions.values[i] += each[i % 3];
        } else if constexpr (std::is_same_v<Kind, Implicit>) {  // its specimen's
          kind.parameters["a"] += by.x, kind.parameters["b"] += by.y, kind.parameters["c"] += by.z;
          shift(kind.bounds.min, by), shift(kind.bounds.max, by);
        } else {
          return false;
        }
        return true;
      },
      shape);
}

inline Vec3d random_offset(Random& random) {
  const Vec3d way = random.direction();
  return way * std::pow(10, random.in(3, 7));
}

// ---- comparing --------------------------------------------------------------------------------

inline RenderOptions drawn_by(IntegratorName integrator) {
  RenderOptions options;
  options.integrator = integrator;
  return options;
}

// Of how many pixels a component differs by more than the tolerance, clamped to `most`.
inline int different(const Image& a, const Image& b, float tolerance, float most = 1) {
  int count = 0;
  for (std::size_t i = 0; i < a.rgb.size(); i += 3) {
    bool differs = false;
    for (std::size_t k = i; k < i + 3; ++k)
      differs |= !(std::fabs(std::min(a.rgb[k], most) - std::min(b.rgb[k], most)) <= tolerance);
    count += differs;
  }
  return count;
}

// 1 pixel of 1000 may differ by more than 2/255.
inline void expect_alike(const Scene& scene, const Scene& far) {
  constexpr int few = far_width * far_height / 1000;
  const auto worlds = std::array{compile(scene), compile(far)};
  const auto views = std::array{view_of(scene.camera, far_width, far_height),
                                view_of(far.camera, far_width, far_height)};
  const auto drawn = [&](std::size_t i, IntegratorName integrator) {
    return picture(worlds[i], views[i], {0, 0, far_width, far_height}, drawn_by(integrator)).image;
  };
  for (const IntegratorName integrator :
       {IntegratorName::whitted, IntegratorName::thesis, IntegratorName::shadow,
        IntegratorName::normal, IntegratorName::albedo, IntegratorName::object}) {
    if (sanitized() && integrator != IntegratorName::whitted) continue;
    EXPECT_LE(different(drawn(0, integrator), drawn(1, integrator), 2.0F / 255), few)
        << Names<IntegratorName>::names[static_cast<std::size_t>(integrator)];
  }
  const auto depth = IntegratorName::depth;
  EXPECT_LE(different(drawn(0, depth), drawn(1, depth), 1e-3F, 1e6F), few);
}

// ---- scenes -----------------------------------------------------------------------------------

inline Material random_finish(Random& random) {
  Finish finish;
  finish.color = random_color(random);
  finish.specular = 0.5 * random.unit();
  switch (random.below(5)) {
    case 0: finish.reflection = 0.5; break;
    case 1:
      finish.transmission = 0.8;
      finish.fresnel = random.chance(0.5);
      break;
    case 2: finish.texture = Texture{Checker{}}; break;
    default: break;
  }
  return {finish};
}

inline void light_up(Scene& scene) {
  SpotLight spot;
  spot.position = Vec3d{9, 20, 20};
  QuadLight quad{Vec3d{-14, 12, 0}, {3, 0, 0}, {0, 0, 3}, 4};
  Light last = point_light({3, 25, 9}, {0.3, 0.2, 0.4});
  last.fade_distance = 20;
  scene.lights = {{spot, {0.5, 0.5, 0.5}},
                  {quad, {0.3, 0.3, 0.3}},
                  sphere_light({-14, 9, 9}, 1, {0.2, 0.2, 0.2}),
                  last};
  scene.background = {0.1, 0.2, 0.3};
  scene.camera.location = {3, 4, 25};
  scene.camera.look_at = Vec3d{0, -1, 0};
  scene.camera.fov_degrees = 50;
}

inline Scene scene_of_all_kinds(std::uint64_t seed) {
  Random random(seed);
  Scene scene = mixed_scene(random, 50, 1);
  for (Object& object : scene.objects.edit())
    if (random.chance(0.8)) object.material = random_finish(random);
  light_up(scene);
  return scene;
}

template <class... Kinds>
Scene scene_of(std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  const auto add = [&]<class Kind>(std::in_place_type_t<Kind>) {
    Object object = object_of(Specimen<Kind>::make(random, 1));
    translate(object, random.point(6));
    object.material = random_finish(random);
    scene.objects.push_back(object);
  };
  for (int i = 0; i < 2; ++i) (add(std::in_place_type<Kinds>), ...);
  light_up(scene);
  return scene;
}
inline Scene scene_of_formulas(std::uint64_t seed) {
  return scene_of<Implicit, Explicit, Parametric, Blend, Voxels, Quadric, Algebraic, Torus, Steiner,
                  Heart, Clebsch>(seed);
}
inline Scene scene_of_numbers(std::uint64_t seed) {
  Scene scene =
      scene_of<Sphere, Box, Disc, Cylinder, Cone, Capsule, Triangle, Voxels, Implicit, Plane>(seed);
  Random random(seed);
  for (int i = 0; i < 4; ++i) {
    Object mesh = object_of(random_mesh(random, random.point(5), 2));
    mesh.material = random_finish(random);
    scene.objects.push_back(mesh);
  }
  return scene;
}

}  // namespace tia::test
