#include "server/requests/exposure.h"

#include <algorithm>

#include "core/render/sampler.h"
#include "core/scene/open_time.h"

namespace tia::server {
namespace {

// The samples that every pixel has, or may have where noise decides.
int samples_of(const SceneOptions& in_effect) {
  const int samples = in_effect.samples.value_or(in_effect.usual_samples());
  return least_samples(samples, in_effect.threshold.value_or(0));
}

bool has_shutter(const FoundScene& found) {
  return found.moving && found.moving->animation->shutter > 0;
}

void check_blur_steps(int asked, const FoundScene& found, const SceneOptions& in_effect) {
  const auto refuse = [&](const std::string& allowed) {
    throw InputError({FaultKind::conflict, "/blur_steps", Value(asked), allowed});
  };
  if (!has_shutter(found)) refuse("a scene whose animation has a shutter");
  const int samples = samples_of(in_effect);
  if (asked > samples)
    refuse("at most the samples of a pixel, which are " + std::to_string(samples));
}

Exposure of_one_moment(const KnownScene& plain) { return {{}, 0, {plain}, {0}}; }

KnownScene exposed(const FoundScene& found, const RenderContext& context,
                   const Requester& requester) {
  return context.go_through(found.moving.others, requester, [&] {
    return KnownScene{std::make_shared<const Scene>(exposed_scene(*found.moving, *found.plain)),
                      found.moving.objects, found.moving.others, found.moving.models};
  });
}

}  // namespace

Exposure exposure_of(const TraceRequest& asked, const FoundScene& found, SceneOptions& in_effect,
                     const RenderContext& context, const Requester& requester) {
  if (asked.blur_steps) check_blur_steps(*asked.blur_steps, found, in_effect);
  const int usual = std::min(SceneOptions::usual_blur_steps, samples_of(in_effect));
  const int steps = std::min(in_effect.blur_steps.value_or(usual), samples_of(in_effect));
  in_effect.blur_steps = std::nullopt;
  if (!has_shutter(found) || steps == 1) return of_one_moment(found.plain);
  Exposure exposure{exposed(found, context, requester), found.seconds, {}, {}};
  const Animation& animation = *exposure.moving->animation;
  std::vector<double> times = stratum_times(animation, found.seconds, steps);
  times.push_back(found.seconds);
  if (!moves_within(animation, times)) return of_one_moment(found.plain);
  times.pop_back();
  for (const double time : times) {
    KnownScene scene = scene_at(exposure.moving, time, asked.along, context, requester);
    const bool is_another = exposure.scenes.empty() || !(*scene == *exposure.scenes.back());
    if (is_another) exposure.scenes.push_back(std::move(scene));
    exposure.strata.push_back(exposure.scenes.size() - 1);
  }
  if (exposure.scenes.size() == 1) return of_one_moment(exposure.scenes.front());
  if (steps != usual) in_effect.blur_steps = steps;
  return exposure;
}

// Scenes of the same objects share what these compile to, whether the store keeps it or not.
std::vector<World> worlds_of(const Exposure& exposure, const RenderContext& context,
                             const Workers& workers) {
  std::vector<World> worlds;
  for (const KnownScene& scene : exposure.scenes) {
    const std::size_t before = worlds.empty() ? 0 : worlds.size() - 1;
    if (worlds.empty() || exposure.scenes[before].objects.digest != scene.objects.digest)
      worlds.push_back(context.geometries.compile(scene, workers));
    else
      workers.alone([&] { worlds.push_back(compile(*scene, worlds.back().of_objects, workers)); });
  }
  return worlds;
}

}  // namespace tia::server
