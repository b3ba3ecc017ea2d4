#include "server/requests/draw.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "core/input/json.h"
#include "server/requests/denoise_check.h"
#include "server/requests/exr_picture.h"
#include "server/requests/gaze_request.h"
#include "server/requests/linear_file.h"
#include "server/requests/parts.h"
#include "server/requests/recipe.h"
#include "server/requests/studio.h"
#include "server/requests/whole_picture.h"
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
      plan.scene->options.transparent_shadows, plan.layers.bits(), plan.gaze.has_value());
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

// Errors: InputError (conflict) where several views are asked for what only a single one has.
void check_several(const PictureRequest& asked, const Plan& plan) {
  const bool is_sheet = plan.scene->sheet.has_value();
  const auto check = [&](bool refused, const char* name, const auto& given) {
    if (!refused || !given) return;
    throw InputError({FaultKind::conflict, std::string("/") + name, write_value(*given),
                      is_sheet ? "a picture of one view; this one's scene is a sheet of several"
                               : "a picture of one view; this one's camera has a display"});
  };
  check(is_sheet, "crop", asked.crop);
  check(is_sheet || plan.is_mixed(), "aov", asked.aov);
  check(plan.has_several(), "gaze", asked.gaze);
  check(plan.has_several(), "budget_ms", asked.budget_ms);
  check(plan.has_several(), "max_rays", asked.max_rays);
  check(asked.format == Format::zip, "crop", asked.crop);
  if (is_sheet && asked.format == Format::zip)
    throw InputError({FaultKind::conflict, "/format", write_value(asked.format),
                      "a file of one picture, for a scene that is a sheet"});
}

// Errors: InputError (conflict) where a picture of an open time has not as many views all the time.
void check_same_views(const Plan& plan) {
  for (const KnownScene& each : plan.exposure.scenes)
    if (!plan.scene->sheet &&
        views_of(each->camera, plan.view.width, plan.view.height).views.size() !=
            plan.views.views.size())
      throw InputError({FaultKind::conflict, "/blur_steps", Value(plan.exposure.blur_steps()),
                        "1 where the camera's display changes while the shutter is open"});
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

// A plan but for what is told of it.
Plan checked_plan(const PictureRequest& asked, const FoundScene& found,
                  const RenderContext& context, const Requester& requester) {
  check_size(asked.width, asked.height, context.limits);
  const KnownScene& scene = found.plain;
  SceneOptions in_effect = options_in_effect(scene->options, asked);
  check_rounds(asked, in_effect);
  check_format(asked, *scene, in_effect.integrator);
  check_depth_range(asked, in_effect.integrator);
  if (!holds_codes(asked.format) && !in_effect.noise) in_effect.show_by({});
  Exposure exposure = exposure_of(asked, found, in_effect, context, requester);
  RenderOptions options = options_of(in_effect, context.limits);
  options.blur_steps = exposure.blur_steps();
  options.threads =
      std::min(asked.threads.value_or(context.pool.threads()), context.pool.threads());
  options.denoise = asked.denoise;
  WholePicture whole = whole_picture(*scene, asked.width, asked.height, context.limits);
  Plan plan{.scene = scene,
            .exposure = std::move(exposure),
            .view = view_of(scene->camera, asked.width, asked.height),
            .window = window_within(whole.size, asked),
            .whole = whole.size,
            .views = std::move(whole.views),
            .in_effect = in_effect,
            .options = options,
            .display = {display_of(in_effect.integrator), in_effect.tone()},
            .format = asked.format,
            .asked = &asked,
            .fewest_samples = fewest_samples(asked, options)};
  check_several(asked, plan);
  check_same_views(plan);
  if (asked.format == Format::exr) {
    plan.layers = plan.options.layers = asked.layers_in_effect();
    check_layers(plan, context.limits);
  }
  check_denoise(plan);
  plan_gaze(context, requester, plan);
  check_rays(plan.points(), plan.fewest_samples, context.limits);
  return plan;
}

}  // namespace

Plan checked_plan_of(const PictureRequest& asked, const RenderContext& context,
                     const Requester& requester) {
  check_size(asked.width, asked.height, context.limits);
  return checked_plan(asked, found_scene(asked, context, requester), context, requester);
}

Plan plan_of(const PictureRequest& asked, const RenderContext& context,
             const Requester& requester) {
  check_size(asked.width, asked.height, context.limits);
  return plan_of(asked, found_scene(asked, context, requester), context, requester);
}

Plan plan_of(const PictureRequest& asked, const FoundScene& found, const RenderContext& context,
             const Requester& requester) {
  Plan plan = checked_plan(asked, found, context, requester);
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
  return Studio(plan, context, stop, onlooker).picture([&](const Workers& workers) {
    return worlds_of(plan.exposure, context, workers);
  });
}

}  // namespace tia::server
