#include <malloc.h>

#include <chrono>

#include "core/accel/world/trace.h"
#include "tests/bench/rays/tracers.h"

namespace tia::bench {
namespace {

// What malloc has given out, in pieces of its heaps and in mappings of their own.
double heap_bytes() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks) + static_cast<double>(info.hblkhd);
}

}  // namespace

TiaIndex::TiaIndex(const Geometry& geometry, Pool& pool) {
  const double before = heap_bytes();
  {
    const Scene scene = scene_of(geometry);
    const auto start = std::chrono::steady_clock::now();
    world_ = std::make_unique<World>(compile(scene, pool.workers(pool.threads())));
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
    built_.ms = took.count();
  }  // a service may forget the scene: what the world itself keeps is what counts
  built_.bytes = heap_bytes() - before;
}

void TiaIndex::trace(const RaySet& rays, Answers& answers) const {
  WorkCounter work;
  const WorldLight& light = world_->lights.front();
  for (std::size_t i = 0; i < rays.size(); i += Wide::size) {
    const Wide t_max = load<Wide>(&rays.t_max[i]);
    const Mask<Wide> active = t_max >= Wide(0);
    if (!any(active)) continue;
    const Ray<Wide> ray{vector_at<Wide>(rays.origin, i), vector_at<Wide>(rays.direction, i)};
    const Wide t = rays.any_hit() ? select(occluded<Wide>(*world_, ray, t_max, light, active, work),
                                           Wide(0), Wide(infinity))
                                  : closest_hit<Wide>(*world_, ray, active, work).t;
    store(t, &answers[i]);
  }
}

}  // namespace tia::bench
