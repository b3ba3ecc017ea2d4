#include "core/render/explain_paths.h"

#include "core/render/explained_ray.h"

namespace tia {
namespace {

// Traces all paths: path(i, world view) is the i-th; and tells what is told of them.
template <class Trace>
void trace_paths(PathExplanation& all, const Scene& scene, const View* view,
                 const WhichPaths& which, const RenderOptions& options, const std::stop_token& stop,
                 Trace path_of) {
  ExplanationSize size(all.ray.world, all.ray.labels);
  tell_hits(all.ray, size);
  RayMeter meter(options.max_rays, options.max_work, stop);
  WorldView world_view = world_view_of(all.ray.world, view, options, meter);
  PathGroups groups(all.ray.world);
  const int count = least_samples(options.samples, options.threshold);
  for (int i = 0; i < count; ++i) {
    PathRecord path = path_of(i, world_view);
    groups.add(path);
    meter.add_if_many(world_view.rays);
    if (i < which.first || i - which.first >= which.count) continue;
    size.path(path);
    all.paths.push_back({i, std::move(path)});
  }
  meter.add(world_view.rays);
  all.count = groups.count();
  all.mean = groups.mean();
  all.groups = groups.groups();
  all.surfaces = groups.surfaces();
  for (std::size_t i = 0; i < all.groups.size(); ++i) size.path_group();
  for (const PathSurface& each : all.surfaces) size.path_surface(each.primitive);
  tell_rest(all.ray, scene, options.integrator, size);
}

}  // namespace

PathExplanation explain_paths(const Scene& scene, World world, const Ray<double>& ray,
                              const WhichPaths& which, const RenderOptions& options,
                              const std::stop_token& stop) {
  PathExplanation all{{std::move(world), object_labels(scene), {}, ray, {}, {}}};
  const Ray<float> traced = traced_in(all.ray.world, ray);
  trace_paths(all, scene, nullptr, which, options, stop, [&](int i, WorldView& world_view) {
    const SamplerState<float> state{{}, {}, static_cast<std::uint32_t>(i), RandomKey(options.seed)};
    return explain_path(world_view, traced, state);
  });
  return all;
}

PathExplanation explain_paths(const Scene& scene, World world, const View& view, int x, int y,
                              const WhichPaths& which, const RenderOptions& options,
                              const std::stop_token& stop) {
  const View in_world = view.seen_from(world.origin);
  const PixelRays rays(view, in_world, x, y, options);
  PathExplanation all{{std::move(world),
                       object_labels(scene),
                       rays.pixel(which.first),
                       rays.exact(which.first),
                       {},
                       {}}};
  trace_paths(all, scene, &in_world, which, options, stop, [&](int i, WorldView& world_view) {
    return explain_path(world_view, rays.traced(i), rays.state(i));
  });
  return all;
}

}  // namespace tia
