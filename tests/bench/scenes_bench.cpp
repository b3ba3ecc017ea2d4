// What many things cost a ray, and how much of two processors many rays a pixel use.
#include <benchmark/benchmark.h>

#include <ctime>

#include "core/film/film.h"
#include "core/film/png.h"
#include "core/render/render.h"
#include "core/scene/keys.h"
#include "core/scene/read_scene.h"
#include "server/stores/gallery.h"
#include "tests/bench/pool.h"
#include "tests/bench/rays/geometry.h"

namespace tia::bench {
namespace {

using benchmark::State;

// n balls that fill a ninth of a cube, whatever n.
Scene balls(int n) {
  Scene scene = scene_of(geometry_kinds()[0].make(n));
  scene.camera.location = {0, 0, 4};
  scene.camera.fov_degrees = 40;
  return scene;
}

RayCounts draw(const Scene& scene, const World& world, const RenderOptions& options) {
  LinearFilm film(640, 480);
  return render(world, view_of(scene.camera, 640, 480), {0, 0, 640, 480}, options, pool(), {},
                [&](const FilmTile& tile) { film.put(tile); })
      .rays;
}

void many_balls(State& state) {
  const Scene scene = balls(static_cast<int>(state.range(0)));
  const World world = compile(scene);
  RayCounts rays;
  for ([[maybe_unused]] auto _ : state) rays = draw(scene, world, {.threads = 1});
  state.counters["rays"] = static_cast<double>(rays.primary + rays.shadow);
}
BENCHMARK(many_balls)->ArgName("n")->Arg(100)->Arg(10'000)->UseRealTime();

void every_shape(State& state) {
  const server::Gallery gallery;
  const Scene& scene = *gallery.find("shapes");
  const World world = compile(scene);
  const int samples = static_cast<int>(state.range(0));
  double processors = 0;
  for ([[maybe_unused]] auto _ : state) {
    const std::clock_t before = std::clock();
    const auto start = std::chrono::steady_clock::now();
    draw(scene, world, {.threads = 2, .samples = samples});
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    processors = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC / took.count();
  }
  state.counters["processors"] = processors;
}
BENCHMARK(every_shape)->ArgName("samples")->Arg(1)->Arg(64)->Iterations(1)->UseRealTime();

}  // namespace
}  // namespace tia::bench
