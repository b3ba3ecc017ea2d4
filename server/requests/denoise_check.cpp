#include "server/requests/denoise_check.h"

#include <algorithm>

#include "core/input/codec.h"

namespace tia::server {

void check_denoise(const Plan& plan) {
  const auto refuse = [](const std::string& allowed) {
    throw InputError({FaultKind::conflict, "/denoise", Value(true), allowed});
  };
  if (!plan.options.denoise) return;
  if (!gathers_light(plan.options.integrator))
    refuse("an integrator that gathers light; this picture's is " +
           std::string(name_of(plan.options.integrator)));
  if (least_samples(plan.options.samples, plan.options.threshold) < 2)
    refuse("more than one sample a pixel");
  if (plan.layers.any([](const LayerRow& row) { return row.is_beside(); }))
    refuse(
        "layers that are not of the samples, whose noise is their own (rgba, normal, albedo, Z, "
        "object)");
}

}  // namespace tia::server
