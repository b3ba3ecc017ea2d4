#include "core/render/explain.h"

#include "core/integrators/whitted.h"
#include "core/render/explained_ray.h"

namespace tia {
namespace {

std::unique_ptr<RayNode> tree_of(const World& world, const Ray<float>& ray,
                                 const SamplerState<float>& sampler_state, const View* view,
                                 const RenderOptions& options, ExplanationSize& size,
                                 const std::stop_token& stop) {
  RayMeter meter(options.max_rays, options.max_work, stop);
  WorldView world_view = world_view_of(world, view, options, meter);
  const RayTreeLimit limit{
      [&](const Hit<float>& hit) { size.ray(hit); },
      [&](TermName name, const LightRecord& light) { size.term(name, light); }};
  return explain_whitted(world_view, ray, sampler_state, limit);
}

// The tree of `traced`, which is all.ray in float and in the world; `view`: there, or null.
void explain_rays(Explanation& all, const Scene& scene, const Ray<float>& traced,
                  const SamplerState<float>& sampler_state, const View* view,
                  const RenderOptions& options, const std::stop_token& stop) {
  ExplanationSize size(all.world, all.labels);
  tell_hits(all, size);
  all.tree = tree_of(all.world, traced, sampler_state, view, options, size, stop);
  tell_rest(all, scene, options.integrator, size);
}

}  // namespace

Explanation explain(const Scene& scene, World world, const Ray<double>& ray,
                    const RenderOptions& options, const std::stop_token& stop) {
  Explanation all{std::move(world), object_labels(scene), {}, ray, {}, {}};
  explain_rays(all, scene, traced_in(all.world, ray), SamplerState<float>{}, nullptr, options,
               stop);
  return all;
}

Explanation explain(const Scene& scene, World world, const View& view, int x, int y, int sample,
                    const RenderOptions& options, const std::stop_token& stop) {
  const View in_world = view.seen_from(world.origin);
  Explanation all{std::move(world), object_labels(scene), {}, {}, {}, {}};
  const Instant at{all.world, view};
  const PixelRays rays({&at, 1}, x, y, options);
  rays.check(sample, sample + 1);
  all.pixel = rays.pixel(sample);
  all.ray = rays.exact(sample);
  explain_rays(all, scene, rays.traced(sample), rays.state(sample), &in_world, options, stop);
  return all;
}

}  // namespace tia
