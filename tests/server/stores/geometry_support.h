// Scenes for what compiles and keeps them, and their pictures.
#pragma once

#include "server/stores/geometry_store.h"
#include "tests/core/accel/worlds.h"
#include "tests/server/support.h"

namespace tia::test {

inline constexpr std::int64_t plenty = 1 << 30;

// A bowl of 2 n^2 triangles.
inline Mesh bowl(int n, double depth = 1) {
  Mesh mesh;
  for (int i = 0; i <= n; ++i)
    for (int k = 0; k <= n; ++k) {
      const double x = 2.0 * i / n - 1, y = 2.0 * k / n - 1;
      mesh.positions.values.insert(mesh.positions.values.end(), {x, y, depth * (x * x + y * y)});
    }
  const auto at = [&](int i, int k) { return static_cast<std::uint32_t>(i * (n + 1) + k); };
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k)
      mesh.indices.values.insert(
          mesh.indices.values.end(),
          {at(i, k), at(i + 1, k), at(i, k + 1), at(i + 1, k), at(i, k + 1), at(i + 1, k + 1)});
  return mesh;
}
// Two objects of one mesh, a ball and a light.
inline Scene two_bowls(int n, double depth = 1) {
  Scene scene;
  scene.objects = {object_of(bowl(n, depth)), object_of(bowl(n, depth), {{Translate{{3, 0, 0}}}}),
                   object_of(Sphere{{0, 3, 0}, 1})};
  scene.lights = {sphere_light({0, 9, 9}, 1)};
  return scene;
}
/// Of a scene that is the caller's.
inline World compiled(GeometryStore& store, const Scene& scene, const Workers& workers = {}) {
  return store.compile(known(SharedScene(SharedScene(), &scene)), workers);
}
inline void compile_in(GeometryStore& store, const Scene& scene) {
  static_cast<void>(compiled(store, scene));
}

/// Scenes of everything there is, with luminous lights.
inline Scene any_scene(std::uint64_t seed) {
  Random random(seed);
  Scene scene = mixed_scene(random, 12, 1);
  scene.camera.location = {0, 2, 25};
  scene.camera.look_at = Vec3d{};
  scene.materials["glow"] = matte({1, 1, 1}, {0.2, 0.4, 0.1});
  scene.objects.push_back(object_of(Sphere{{0, 6, 0}, 1}));
  scene.objects.back().material = "glow";
  QuadLight quad;
  quad.corner = Vec3d{-2, 8, 2};
  quad.u = {2, 0, 0};
  quad.v = {0, 0, 2};
  scene.lights = {sphere_light({5, 5, 9}, 1), point_light({-9, 9, 9}), Light{quad, {1, 1, 1}, 1}};
  return scene;
}

inline std::vector<float> pixels_of(const World& world, const Scene& scene) {
  constexpr int width = 40, height = 30;
  LinearFilm film(width, height);
  RenderOptions options;
  options.integrator = IntegratorName::whitted;
  options.max_depth = 3;
  render(world, view_of(scene.camera, width, height), {0, 0, width, height}, options, host().pool(),
         {}, [&](const FilmTile& tile) { film.put(tile); });
  return film.image().rgb;
}

}  // namespace tia::test
