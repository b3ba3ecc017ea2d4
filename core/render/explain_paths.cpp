#include "core/render/explain_paths.h"

#include <deque>

#include "core/render/explained_ray.h"

namespace tia {
namespace {

// Traces all paths: path(i, world view) is the i-th; and tells what is told of them. `views`: those
// of the worlds, in their spaces, or none.
template <class Trace>
void trace_paths(PathExplanation& all, const Scene& scene, const std::vector<View>& views,
                 const WhichPaths& which, const RenderOptions& options, const std::stop_token& stop,
                 Trace path_of) {
  ExplanationSize size(all.ray.world, all.ray.labels);
  tell_hits(all.ray, size);
  RayMeter meter(options.max_rays, options.max_work, stop);
  std::deque<WorldView> world_views;
  for (std::size_t i = 0; i < all.worlds.size(); ++i)
    world_views.push_back(
        world_view_of(all.worlds[i], views.empty() ? nullptr : &views[i], options, meter));
  PathGroups groups;
  const int count = least_samples(options.samples, options.threshold);
  for (int i = 0; i < count; ++i) {
    WorldView& world_view = world_views[static_cast<std::size_t>(i) % world_views.size()];
    PathRecord path = path_of(i, world_view);
    groups.add(path, world_view.world);
    meter.add_if_many(world_view.rays);
    if (i < which.first || i - which.first >= which.count) continue;
    size.path(path, world_view.world);
    all.paths.push_back({i, std::move(path)});
  }
  for (WorldView& each : world_views) meter.add(each.rays);
  all.count = groups.count();
  all.mean = groups.mean();
  all.groups = groups.groups();
  all.surfaces = groups.surfaces();
  for (std::size_t i = 0; i < all.groups.size(); ++i) size.path_group();
  for (const PathSurface& each : all.surfaces) size.path_surface(each.object);
  tell_rest(all.ray, scene, options.integrator, size);
}

}  // namespace

PathExplanation explain_paths(const Scene& scene, World world, const Ray<double>& ray,
                              const WhichPaths& which, const RenderOptions& options,
                              const std::stop_token& stop) {
  PathExplanation all{{world, object_labels(scene), {}, ray, {}, {}}, {}};
  all.worlds.push_back(std::move(world));
  const Ray<float> traced = traced_in(all.ray.world, ray);
  trace_paths(all, scene, {}, which, options, stop, [&](int i, WorldView& world_view) {
    const SamplerState<float> state{{}, {}, static_cast<std::uint32_t>(i), RandomKey(options.seed)};
    return explain_path(world_view, traced, state);
  });
  return all;
}

PathExplanation explain_paths(const Scene& scene, SeenWorlds seen, int x, int y,
                              const WhichPaths& which, const RenderOptions& options,
                              const std::stop_token& stop) {
  const std::size_t first = static_cast<std::size_t>(which.first) % seen.worlds.size();
  PathExplanation all{{seen.worlds[first], object_labels(scene), {}, {}, {}, {}}, {}};
  all.worlds = std::move(seen.worlds);
  std::vector<Instant> instants;
  std::vector<View> in_worlds;
  for (std::size_t i = 0; i < all.worlds.size(); ++i) {
    instants.push_back({all.worlds[i], seen.views[i]});
    in_worlds.push_back(seen.views[i].seen_from(all.worlds[i].origin));
  }
  const PixelRays rays(instants, x, y, options);
  rays.check(0, least_samples(options.samples, options.threshold));
  all.ray.pixel = rays.pixel(which.first);
  all.ray.ray = rays.exact(which.first);
  trace_paths(all, scene, in_worlds, which, options, stop, [&](int i, WorldView& world_view) {
    return explain_path(world_view, rays.traced(i), rays.state(i));
  });
  return all;
}

}  // namespace tia
