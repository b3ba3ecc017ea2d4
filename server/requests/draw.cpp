#include "server/requests/draw.h"

#include <algorithm>
#include <chrono>
#include <tuple>
#include <utility>
#include <vector>

#include "core/film/film.h"
#include "core/film/png.h"
#include "core/film/png_text.h"
#include "core/input/json.h"
#include "server/http/error.h"
#include "server/operation/memory_costs.h"
#include "server/operation/timing.h"
#include "server/requests/exr_picture.h"
#include "server/requests/linear_file.h"
#include "server/requests/parts.h"
#include "server/requests/recipe.h"
#include "server/stores/digest.h"

namespace tia::server {
namespace {

// What a ray meets, how it is traced, and the lights but for where they are, so that a light that
// is dragged is known. By its digest: of many lights it would be long.
std::string cost_key_of(const Plan& plan) {
  std::string key = hex(plan.scene.objects.digest);
  const auto add = [&](const auto&... parts) { ((key += ' ' + std::to_string(parts)), ...); };
  add(static_cast<int>(plan.options.integrator), plan.options.max_depth, plan.options.ao_radius,
      plan.options.threshold, plan.options.noise, plan.scene->options.transparent_shadows,
      plan.layers.bits());
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
  if (asked.has_budget()) return std::min(options.samples, Sampler::first_round);
  if (options.noise > 0) return std::min(options.samples, Convergence::least_samples);
  return least_samples(options.samples, options.threshold);
}

}  // namespace

Plan plan_of(const PictureRequest& asked, const RenderContext& context,
             const Requester& requester) {
  check_size(asked.width, asked.height, context.limits);
  const KnownScene scene = scene_of(asked, context, requester);
  SceneOptions in_effect = options_in_effect(scene->options, asked);
  check_rounds(asked, in_effect);
  check_format(asked, *scene, in_effect.integrator);
  check_depth_range(asked, in_effect.integrator);
  check_sheet(asked, *scene);
  if (asked.format != Format::png && !in_effect.noise) in_effect.show_by({});
  RenderOptions options = options_of(in_effect, context.limits);
  options.threads =
      std::min(asked.threads.value_or(context.pool.threads()), context.pool.threads());
  const Window window = whole_window(asked, *scene);
  check_size(window.x1, window.y1, context.limits);
  check_rays(static_cast<std::int64_t>(window.width()) * window.height(),
             fewest_samples(asked, options), context.limits);
  Plan plan{.scene = scene,
            .view = view_of(scene->camera, asked.width, asked.height),
            .window = window,
            .in_effect = in_effect,
            .options = options,
            .display = {display_of(in_effect.integrator), in_effect.tone()},
            .format = asked.format,
            .asked = &asked};
  if (asked.format == Format::exr) {
    plan.layers = plan.options.layers = asked.layers_in_effect();
    check_layers(plan, context.limits);
  }
  const std::size_t objects = scene.objects.bytes <= most_told_bytes ? scene.objects.bytes : 0;
  std::tie(plan.recipe, plan.cost_key) = context.go_through(scene.others + objects, requester, [&] {
    return std::pair(recipe_of(asked, plan), cost_key_of(plan));
  });
  return plan;
}

namespace {

std::int64_t memory_of_pixels(const Plan& plan, std::size_t pixels) {
  if (plan.format == Format::exr)
    return memory_for(memory_cost::layers, pixels * static_cast<std::size_t>(plan.layers.planes()));
  if (plan.format != Format::png) return memory_for(memory_cost::linear, pixels);
  const bool alpha = is_transparent(*plan.scene, plan.options.integrator);
  return memory_for(alpha ? memory_cost::alpha : memory_cost::png, pixels);
}
std::int64_t memory_of(const Plan& plan) {
  const auto pixels = static_cast<std::size_t>(plan.window.width()) *
                      static_cast<std::size_t>(plan.window.height());
  return memory_for(memory_cost::request, 1) + memory_of_pixels(plan, pixels) +
         (plan.asked->has_budget() ? memory_for(memory_cost::rounds, pixels) : 0);
}

// From now on. Errors: as render(); HttpError (budget) where there is no time for one round;
// InputError where there are no rays for it.
class BudgetOfRequest {
 public:
  explicit BudgetOfRequest(const PictureRequest& asked) : asked_(asked) {}

  RenderOptions options_of(const Plan& plan) const {
    RenderOptions options = plan.options;
    if (!asked_.has_budget()) return options;
    Budget& budget = options.budget.emplace();
    if (asked_.max_rays) budget.max_rays = *asked_.max_rays;
    if (asked_.budget_ms)
      budget.has_time = [start = Clock::now(), ms = *asked_.budget_ms](double more) {
        const std::chrono::duration<double, std::milli> taken = Clock::now() - start;
        return taken.count() * (1 + more) < ms;
      };
    return options;
  }
  [[noreturn]] void refuse(const BudgetSpent& spent) const {
    if (spent.of() == BudgetSpent::Of::rays)
      throw InputError(
          {FaultKind::limit, "/max_rays", write_value(*asked_.max_rays),
           "more than a first round of 16 samples a pixel takes: from the eye alone " +
               std::to_string(16LL * asked_.window().width() * asked_.window().height())});
    throw HttpError("budget",
                    "budget_ms of " + std::to_string(*asked_.budget_ms) +
                        " was over before each pixel had the 16 samples of a first round; ask for "
                        "more time or fewer pixels",
                    {{"Retry-After", "1"}});
  }

 private:
  using Clock = std::chrono::steady_clock;
  const PictureRequest& asked_;
};

// The recipe of what has been drawn where the budget's end has decided that.
std::string recipe_of_reached(const Plan& plan, int samples) {
  Plan reached = plan;
  reached.in_effect.samples = samples;
  if (samples == reached.in_effect.usual_samples()) reached.in_effect.samples = std::nullopt;
  return recipe_of(*plan.asked, reached);
}

}  // namespace

Picture draw(const Plan& plan, const RenderContext& context, const std::stop_token& stop) {
  Picture picture;
  Stopwatch watch;
  Flow own;
  Flow& flow = plan.options.flow != nullptr ? *plan.options.flow : own;
  const Workers workers = context.pool.workers(plan.options.threads, stop, &flow);
  const World world = context.geometries.compile(plan.scene, workers);
  reserve_memory(memory_of(plan), "this picture", stop);
  picture.degenerate = world.degenerate;
  if (plan.options.integrator == IntegratorName::path)
    picture.unasked = world.of_objects->unasked.count;
  picture.timing.build = watch.lap_ms();

  const int width = plan.window.width(), height = plan.window.height();
  const Nanoseconds before = flow.attained;
  std::string recipe = plan.recipe;
  const auto trace_onto = [&](auto& film) {
    const BudgetOfRequest budget(*plan.asked);
    Rendered all;
    try {
      all = trace_parts({plan, budget.options_of(plan), context.pool, workers, stop}, world, film);
    } catch (const BudgetSpent& spent) {
      budget.refuse(spent);
    }
    picture.rays = all.rays;
    picture.reached = all.reached;
    if constexpr (std::is_same_v<decltype(film), ExrPicture&>)
      picture.rays += film.draw_features(picture.reached, world, context.pool, stop);
    if (plan.asked->has_budget())
      workers.alone([&] {
        recipe = recipe_of_reached(plan, picture.reached->samples);
        picture.etag = etag_of(recipe);
      });
    picture.timing.trace = watch.lap_ms();
    picture.trace_seconds = static_cast<double>(flow.attained - before) * 1e-9;
  };
  if (plan.format == Format::exr) {
    ExrPicture film(plan);
    trace_onto(film);
    picture.bytes = film.encode(recipe, workers);
  } else if (plan.format != Format::png) {
    LinearFilm film(width, height);
    trace_onto(film);
    workers.alone([&] { picture.bytes = linear_file(plan, std::move(film).image(), stop); });
  } else if (is_transparent(*plan.scene, plan.options.integrator)) {
    AlphaFilm film(width, height, plan.display);
    trace_onto(film);
    workers.alone([&] { picture.bytes = encode_png(film.image(), stop); });
  } else if (is_cut_in_strips(width, height)) {
    ScanlineFilm film(width, height, plan.display);
    trace_onto(film);
    picture.bytes = encode_png(film.scanlines(), workers);
  } else {
    DisplayFilm film(width, height, plan.display);
    trace_onto(film);
    workers.alone([&] { picture.bytes = encode_png(film.image(), stop); });
  }
  if (plan.format == Format::png)
    workers.alone(
        [&] { picture.bytes = with_text(std::move(picture.bytes), recipe_keyword, recipe); });
  picture.media_type = media_type_of(plan.format);
  picture.timing.encode = watch.lap_ms();
  return picture;
}

}  // namespace tia::server
