#include "server/requests/draw.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "core/input/json.h"
#include "server/requests/denoise_check.h"
#include "server/requests/exr_picture.h"
#include "server/requests/linear_file.h"
#include "server/requests/parts.h"
#include "server/requests/recipe.h"
#include "server/requests/studio.h"
#include "server/stores/digest.h"

namespace tia::server {
namespace {

// What a ray meets, how it is traced, and the lights but for where they are, so that a light that
// is dragged is known. By its digest: of many lights it would be long.
std::string cost_key_of(const Plan& plan) {
  std::string key = hex(plan.scene.objects.digest);
  const auto add = [&](const auto&... parts) { ((key += ' ' + std::to_string(parts)), ...); };
  add(plan.options.denoise, static_cast<int>(plan.options.integrator), plan.options.max_depth,
      plan.options.ao_radius, plan.options.threshold, plan.options.noise,
      plan.scene->options.transparent_shadows, plan.layers.bits());
  if (plan.scene->fog) add(plan.scene->fog->density);
  for (const Light& light : plan.scene->lights) {
    const Value written = write_value(light);
    for (const auto& [name, value] : *written.as<Value::Object>())
      if (value.as<Value::Array>() == nullptr) key += ' ' + to_json(value);
  }
  return sha256_hex(key);
}

// Errors: InputError (conflict) where what stops rounds is asked for and there are none.
void check_rounds(const PictureRequest& asked, const SceneOptions& in_effect) {
  const auto check = [&](const char* name, const auto& given) {
    if (!given) return;
    const auto refuse = [&](const std::string& allowed) {
      throw InputError(
          {FaultKind::conflict, std::string("/") + name, write_value(*given), allowed});
    };
    if (!row_of(in_effect.integrator).is_chance())
      refuse("an integrator whose rays are chance (" + chance_names() + "); this picture's is " +
             std::string(name_of(in_effect.integrator)));
    if (in_effect.threshold) refuse(std::string(name) + " or threshold");
  };
  check("noise", in_effect.noise);
  check("budget_ms", asked.budget_ms);
  check("max_rays", asked.max_rays);
}

void check_format(const PictureRequest& asked, const Scene& scene, IntegratorName integrator) {
  if (!has_alpha(asked.format) && is_transparent(scene, integrator))
    throw InputError({FaultKind::conflict, "/format", write_value(asked.format),
                      alpha_formats() + ", which have alpha, or a backdrop that is a colour"});
}

// Errors: InputError (conflict) where a sheet is asked for what only a single view has.
void check_sheet(const PictureRequest& asked, const Scene& scene) {
  const auto check = [&](const char* name, const auto& given) {
    if (!scene.sheet || !given) return;
    throw InputError({FaultKind::conflict, std::string("/") + name, write_value(*given),
                      "a picture of one view; this one's scene is a sheet of several"});
  };
  check("crop", asked.crop);
  check("aov", asked.aov);
  check("budget_ms", asked.budget_ms);
  check("max_rays", asked.max_rays);
}

// Those that a pixel has in any case.
int fewest_samples(const PictureRequest& asked, const RenderOptions& options) {
  const auto at_least = [&](int samples) {
    return std::min(options.samples, std::max(samples, options.blur_steps));
  };
  if (asked.has_budget()) return at_least(Sampler::first_round);
  if (options.noise > 0) return at_least(Convergence::least_samples);
  return least_samples(options.samples, options.threshold);
}

}  // namespace

Plan plan_of(const PictureRequest& asked, const RenderContext& context,
             const Requester& requester) {
  check_size(asked.width, asked.height, context.limits);
  const FoundScene found = found_scene(asked, context, requester);
  const KnownScene& scene = found.plain;
  SceneOptions in_effect = options_in_effect(scene->options, asked);
  check_rounds(asked, in_effect);
  check_format(asked, *scene, in_effect.integrator);
  check_depth_range(asked, in_effect.integrator);
  check_sheet(asked, *scene);
  if (asked.format != Format::png && !in_effect.noise) in_effect.show_by({});
  Exposure exposure = exposure_of(asked, found, in_effect, context, requester);
  RenderOptions options = options_of(in_effect, context.limits);
  options.blur_steps = exposure.blur_steps();
  options.threads =
      std::min(asked.threads.value_or(context.pool.threads()), context.pool.threads());
  options.denoise = asked.denoise;
  const Window window = whole_window(asked, *scene);
  check_size(window.x1, window.y1, context.limits);
  Plan plan{.scene = scene,
            .exposure = std::move(exposure),
            .view = view_of(scene->camera, asked.width, asked.height),
            .window = window,
            .in_effect = in_effect,
            .options = options,
            .display = {display_of(in_effect.integrator), in_effect.tone()},
            .format = asked.format,
            .asked = &asked,
            .fewest_samples = fewest_samples(asked, options)};
  if (asked.format == Format::exr) {
    plan.layers = plan.options.layers = asked.layers_in_effect();
    check_layers(plan, context.limits);
  }
  check_denoise(plan);
  const Window traced = plan.traced();
  check_rays(static_cast<std::int64_t>(traced.width()) * traced.height(), plan.fewest_samples,
             context.limits);
  const KnownScene& told = told_scene_of(plan);
  const std::size_t objects = told.objects.bytes <= most_told_bytes ? told.objects.bytes : 0;
  std::tie(plan.recipe, plan.rounds_name, plan.cost_key) =
      context.go_through(told.others + objects, requester, [&] {
        return std::tuple(recipe_of(asked, plan), rounds_name_of(asked, plan), cost_key_of(plan));
      });
  return plan;
}

Picture draw(const Plan& plan, const RenderContext& context, const std::stop_token& stop,
             const Onlooker* onlooker) {
  return Studio(plan, context, stop, onlooker).picture();
}

}  // namespace tia::server
