#include "core/render/explain.h"

#include "core/input/codec.h"
#include "core/integrators/whitted.h"
#include "core/render/meter.h"
#include "core/render/sampler.h"
#include "core/scene/left_out.h"

namespace tia {
namespace {

std::unique_ptr<RayNode> tree_of(const World& world, const Ray<float>& ray,
                                 const SamplerState<float>& sampler_state, const View* view,
                                 const RenderOptions& options, ExplanationSize& size,
                                 const std::stop_token& stop) {
  RayMeter meter(options.max_rays, options.max_work, stop);
  WorldView world_view{world,
                       WorkCounter([&](std::int64_t work) { meter.add_work(work); }),
                       rules_of(options),
                       {},
                       0,
                       view != nullptr ? cone_of(*view) : PixelCone{},
                       view};
  const RayTreeLimit limit{
      [&](const Hit<float>& hit) { size.ray(hit); },
      [&](TermName name, const LightRecord& light) { size.term(name, light); }};
  return explain_whitted(world_view, ray, sampler_state, limit);
}

std::vector<Note> notes_of(const Scene& scene, const World& world, IntegratorName integrator) {
  std::vector<Note> notes;
  for (const LeftOut& each : left_out_by(integrator, scene))
    notes.push_back({each.pointer, each.about});
  if (scene.backdrop)
    notes.push_back({"/backdrop",
                     "is what the picture shows where the first ray meets no object; the ray tells "
                     "what is behind it"});
  if (scene.shadow_ground)
    notes.push_back({"/shadow_ground", "the shadow that the picture shows there is not told of"});
  if (scene.sheet) notes.push_back({"/sheet", "the ray is of the scene's own camera"});
  const std::vector<int>& unasked = world.of_objects->unasked.first;
  for (const auto& [number, pointer] : object_pointers(scene, {unasked.begin(), unasked.end()}))
    notes.push_back({pointer, "path meets its light by chance alone, and asks it for none"});
  return notes;
}

// What the ray meets, in double, and the tree of `rounded`, which is the same in float, in the
// world; and the view there whose ray it is, or null.
void explain_rays(Explanation& all, const Scene& scene, const Ray<float>& rounded,
                  const SamplerState<float>& sampler_state, const View* view,
                  const RenderOptions& options, const std::stop_token& stop) {
  ExplanationSize size(all.world, all.labels);
  const Vec3d& origin = all.world.origin;
  all.hits = all_hits(all.world, {all.ray.origin - origin, all.ray.direction});
  for (Meeting& each : all.hits) {
    each.point = each.point + origin;
    size.hit(each);
  }
  all.tree = tree_of(all.world, rounded, sampler_state, view, options, size, stop);
  all.notes = notes_of(scene, all.world, options.integrator);
  for (const Note& each : all.notes) size.note(each.pointer, each.about);
  all.pointers = object_pointers(scene, size.objects());
  all.most_bytes = size.bytes();
}

}  // namespace

Explanation explain(const Scene& scene, World world, const Ray<double>& ray,
                    const RenderOptions& options, const std::stop_token& stop) {
  Explanation all{std::move(world), object_labels(scene), {}, ray, {}, {}};
  const Ray<float> rounded{lift<float>(ray.origin - all.world.origin),
                           normalize(lift<float>(ray.direction))};
  explain_rays(all, scene, rounded, SamplerState<float>{}, nullptr, options, stop);
  return all;
}

Explanation explain(const Scene& scene, World world, const View& view, int x, int y, int sample,
                    const RenderOptions& options, const std::stop_token& stop) {
  const Sampler sampler(options.samples, options.threshold, options.seed);
  const bool centered = sampler.centered();
  const Aim<float> aim = centered ? Aim<float>{} : sampler.aim(x, y, sample);
  const auto ray = [&]<class Real>(const View& eye, const Aim<Real>& at) {
    const Vec3<Real> center = eye.column(static_cast<Real>(x)) + eye.row(static_cast<Real>(y));
    return Eye<Real>(eye).ray(center, at);
  };
  const View in_world = view.seen_from(world.origin);
  const Ray<float> rounded = ray(in_world, aim);
  Explanation all{std::move(world),
                  object_labels(scene),
                  {},
                  ray(view, Aim<double>{aim.dx, aim.dy, aim.lens_x, aim.lens_y}),
                  {},
                  {}};
  const Vec2d raster{x + 0.5 + aim.dx, y + 0.5 + aim.dy};
  const Vec2d ndc{raster.u / view.width, raster.v / view.height};
  all.pixel = {x, y, sample, raster, ndc, {2 * ndc.u - 1, 1 - 2 * ndc.v}};
  const SamplerState<float> sampler_state{{static_cast<std::uint32_t>(x)},
                                          {static_cast<std::uint32_t>(y)},
                                          static_cast<std::uint32_t>(sample),
                                          sampler.key()};
  explain_rays(all, scene, rounded, sampler_state, &in_world, options, stop);
  return all;
}

}  // namespace tia
