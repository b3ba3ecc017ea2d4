#include "server/requests/exr_picture.h"

#include <algorithm>

#include "core/input/codec.h"
#include "core/version.h"

namespace tia::server {
namespace {

void check_layer(const LayerRow& row, const Plan& plan) {
  const auto refuse = [&](const std::string& allowed) {
    const std::vector<Layer>& asked = *plan.asked->aov;
    const auto i = static_cast<std::size_t>(std::ranges::find(asked, row.layer) - asked.begin());
    throw InputError(
        {FaultKind::conflict, Place{}.at("aov").at(i).pointer(), write_value(row.layer), allowed});
  };
  const std::string name(row.text);
  if (row.of_paths && plan.options.integrator != IntegratorName::path)
    refuse(name + " with integrator path, whose light is parted; this picture's is " +
           std::string(name_of(plan.options.integrator)));
  if (row.of_paths && plan.scene->shadow_ground)
    refuse(name + " without shadow_ground, where light that is missing is shown");
  if (!row.of_samples) return;
  if (plan.options.samples < 2) refuse(name + " with at least 2 samples a pixel");
  if (plan.options.threshold > 0)
    refuse(name + " without threshold, which looks at light up to 1 alone");
}

RenderOptions options_of_feature(const Plan& plan, IntegratorName feature, int samples) {
  RenderOptions options = plan.options;
  options.integrator = feature;
  options.layers = {};
  options.denoise = false;
  const int first_round = std::max(Sampler::first_round, options.blur_steps);
  options.samples = options.noise > 0 ? std::min(samples, first_round) : samples;
  options.noise = 0;
  if (!averages(feature)) options.samples = options.blur_steps = 1, options.threshold = 0;
  return options;
}

}  // namespace

void check_layers(const Plan& plan, const Limits& limits) {
  const bool is_open = plan.options.noise > 0 || plan.asked->has_budget();
  const int known = is_open ? 1 : plan.options.samples;
  std::int64_t samples = least_samples(known, plan.options.threshold);
  plan.layers.for_each([&](const LayerRow& row) {
    check_layer(row, plan);
    if (!row.feature) return;
    const RenderOptions options = options_of_feature(plan, *row.feature, known);
    samples += least_samples(options.samples, options.threshold);
  });
  check_rays(static_cast<std::int64_t>(plan.window.width()) * plan.window.height(), samples,
             limits);
}

RayCounts ExrPicture::draw_features(const std::optional<Reached>& reached, const FilmPart& part,
                                    Instants instants, const Instant& frame, Pool& pool,
                                    const std::stop_token& stop) {
  RayCounts rays;
  const bool was_open = plan_.asked->has_budget();
  const int samples = was_open ? reached->samples : plan_.options.samples;
  plan_.layers.for_each([&](const LayerRow& row) {
    if (!row.feature) return;
    const Rendered drawn =
        render(averages(*row.feature) ? instants : Instants{&frame, 1}, part.window,
               options_of_feature(plan_, *row.feature, samples), pool, stop,
               [&](const FilmTile& tile) { film_.put(moved(tile, part), row); });
    rays += drawn.rays;
  });
  return rays;
}

std::string ExrPicture::encode(const std::string& recipe, const Workers& workers) const {
  const ExrHead head{.width = plan_.whole.width(),
                     .height = plan_.whole.height(),
                     .x0 = plan_.window.x0,
                     .y0 = plan_.window.y0,
                     .channels = {},
                     .texts = {{"tia:recipe", recipe}, {"tia:version", full_version()}}};
  const bool halves = plan_.asked->depth.value_or(16) == 16;
  return film_.encode(head, halves ? ExrType::half : ExrType::real, workers);
}

}  // namespace tia::server
