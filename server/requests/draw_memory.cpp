#include "server/requests/draw_memory.h"

#include "core/render/preview_light.h"
#include "server/operation/memory_costs.h"

namespace tia::server {

namespace {

// The views' files beside the picture, or what is mixed.
std::int64_t memory_beside(const Plan& plan, std::size_t pixels) {
  return (plan.format == Format::zip ? memory_for(memory_cost::alpha, pixels) : 0) +
         (plan.is_mixed() ? memory_for(memory_cost::linear, pixels) : 0);
}
std::int64_t memory_of_pixels(const Plan& plan, std::size_t pixels) {
  if (plan.format == Format::exr)
    return memory_for(memory_cost::layers, pixels * static_cast<std::size_t>(plan.layers.planes()));
  if (!holds_codes(plan.format) || plan.takes_light) return memory_for(memory_cost::linear, pixels);
  const bool alpha = is_transparent(*plan.scene, plan.options.integrator);
  return memory_for(alpha ? memory_cost::alpha : memory_cost::png, pixels);
}
// How much more a pixel has where what its rays find is summed, for the denoiser or for a filtered
// preview.
int with_guides(const Plan& plan, std::int64_t pixels, bool is_watched) {
  if (plan.options.denoise) return 3;
  const bool is_filtered = is_watched && row_of(plan.options.integrator).is_chance() &&
                           pixels <= PreviewLight::most_pixels;
  return is_filtered ? 2 : 1;
}
std::int64_t memory_of_rounds(const Plan& plan, bool is_watched) {
  if (!plan.asked->has_budget() && !is_watched) return 0;
  const Window traced = plan.traced();
  const std::int64_t pixels = std::int64_t{traced.width()} * traced.height();
  return memory_for(memory_cost::rounds, static_cast<std::size_t>(pixels)) *
         with_guides(plan, pixels, is_watched);
}
std::int64_t memory_of_denoiser(const Plan& plan) {
  if (!plan.options.denoise) return 0;
  const Window traced = plan.traced();
  const int around = 2 * denoise_margin;
  return memory_for(memory_cost::denoise, static_cast<std::size_t>(traced.width() + around) *
                                              static_cast<std::size_t>(traced.height() + around)) +
         memory_for(memory_cost::denoise_thread, static_cast<std::size_t>(plan.options.threads));
}

std::int64_t memory_of_gaze(const Plan& plan) {
  return plan.gaze ? memory_for(memory_cost::gaze, static_cast<std::size_t>(plan.gaze->all())) : 0;
}

}  // namespace

// For who watches files are made while the film stays.
std::int64_t memory_of(const Plan& plan, bool is_watched) {
  const auto pixels = static_cast<std::size_t>(plan.window.width()) *
                      static_cast<std::size_t>(plan.window.height());
  return memory_for(memory_cost::request, 1) +
         memory_of_pixels(plan, pixels) * (is_watched ? 2 : 1) + memory_beside(plan, pixels) +
         memory_of_rounds(plan, is_watched) + memory_of_denoiser(plan) + memory_of_gaze(plan);
}

}  // namespace tia::server
