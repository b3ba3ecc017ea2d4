// The index alone: building it, and what a packet and a single ray cost in it. tia_rays (rays/) has
// the larger scenes, and Embree beside them.
#include <benchmark/benchmark.h>

#include <array>
#include <map>

#include "core/accel/world/trace.h"
#include "core/boxes/bvh_builder.h"
#include "core/scene/read_scene.h"
#include "tests/bench/rays/geometry.h"
#include "tests/bench/rays/ray_set.h"

namespace tia::bench {
namespace {

using benchmark::State;

// Those around n spheres.
std::vector<Box32> boxes(int n) {
  const std::vector<float> spheres = geometry_kinds()[0].make(n).spheres;
  std::vector<Box32> all;
  for (std::size_t i = 0; i < spheres.size(); i += 4)
    all.push_back(rounded_outwards(
        bounds(Sphere{{spheres[i], spheres[i + 1], spheres[i + 2]}, spheres[i + 3]})));
  return all;
}

void index_build(State& state) {
  const std::vector<Box32> all = boxes(static_cast<int>(state.range(0)));
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(build_bvh(all));
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(index_build)
    ->ArgName("n")
    ->RangeMultiplier(10)
    ->Range(10'000, 1'000'000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

struct Case {
  World world;
  std::array<RaySet, 4> rays;

  Case(const GeometryKind& kind, int n)
      : world(compile(scene_of(kind.make(n)))), rays(make_rays(world)) {}
};

// Kept: making one takes longer than measuring it.
const Case& case_of(std::int64_t kind, std::int64_t n) {
  static std::map<std::pair<std::int64_t, std::int64_t>, Case> cases;
  const auto at = cases.find({kind, n});
  if (at != cases.end()) return at->second;
  const GeometryKind& made = geometry_kinds()[static_cast<std::size_t>(kind)];
  return cases.try_emplace({kind, n}, made, static_cast<int>(n)).first->second;
}

// One iteration is one packet, as many rays as Real has lanes; packets of holes alone are none.
template <class Real, RayKind kind>
void index_trace(State& state) {
  const Case& at = case_of(state.range(0), state.range(1));
  const RaySet& rays = at.rays[static_cast<std::size_t>(kind)];
  WorkCounter work;
  std::int64_t traced = 0;
  std::size_t i = 0;
  for ([[maybe_unused]] auto _ : state) {
    Mask<Real> active(false);
    do {
      i = (i + lanes<Real>) % rays.size();
      active = load<Real>(&rays.t_max[i]) >= Real(0);
    } while (!any(active));
    traced += count(active);
    const Ray<Real> ray{vector_at<Real>(rays.origin, i), vector_at<Real>(rays.direction, i)};
    if constexpr (kind == RayKind::shadow)
      benchmark::DoNotOptimize(occluded<Real>(at.world, ray, load<Real>(&rays.t_max[i]),
                                              at.world.lights.front(), active, work));
    else benchmark::DoNotOptimize(closest_hit<Real>(at.world, ray, active, work));
  }
  state.SetItemsProcessed(traced);
}

// Spheres, and a mesh of triangles: the first two kinds.
void sizes(benchmark::internal::Benchmark* of) {
  of->ArgNames({"kind", "n"})->ArgsProduct({{0, 1}, {10'000, 100'000}});
}
BENCHMARK_TEMPLATE(index_trace, Wide, RayKind::primary)->Apply(sizes);
BENCHMARK_TEMPLATE(index_trace, Wide, RayKind::shadow)->Apply(sizes);
BENCHMARK_TEMPLATE(index_trace, Wide, RayKind::mirror)->Apply(sizes);
BENCHMARK_TEMPLATE(index_trace, Wide, RayKind::diffuse)->Apply(sizes);
BENCHMARK_TEMPLATE(index_trace, float, RayKind::primary)->Apply(sizes);
BENCHMARK_TEMPLATE(index_trace, float, RayKind::shadow)->Apply(sizes);
BENCHMARK_TEMPLATE(index_trace, float, RayKind::diffuse)->Apply(sizes);

}  // namespace
}  // namespace tia::bench
