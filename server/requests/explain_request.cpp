#include "server/requests/explain_request.h"

#include "core/render/explain.h"
#include "core/render/sampler.h"

namespace tia::server {

void FreeRay::check(const Place& at, Faults& faults) const {
  if (!(length(direction) > 1e-100))
    faults.add({FaultKind::out_of_range, at.at("direction").pointer(), write_value(direction),
                "a direction of some length, 1e-100 at least"});
}

void ExplainRequest::check(const Place& at, Faults& faults) const {
  ViewRequest::check(at, faults);
  const auto coordinate = [&](const char* name, const std::optional<int>& is, int size) {
    const std::string place = at.at(name).pointer();
    if (ray && is) faults.add({FaultKind::conflict, place, write_value(*is), "x and y, or ray"});
    else if (!ray && !is)
      faults.add({FaultKind::missing, place, std::nullopt,
                  range_text({.unit = "pixels", .min = 0, .max = size - 1.0}, true) +
                      ", of a pixel with x and y; or a ray"});
  };
  coordinate("x", x, radio ? static_cast<int>(most_px) : width);
  coordinate("y", y, radio ? static_cast<int>(most_px) : height);
  if (radio && ray)
    faults.add({FaultKind::conflict, at.at("ray").pointer(), write_value(*ray), "ray or radio"});
}

void ExplainRequest::check_rays(const RenderOptions& options) const {
  const bool by_paths = options.integrator == IntegratorName::path;
  if (!row_of(options.integrator).is_whitted && !by_paths)
    throw InputError({FaultKind::out_of_range, "/integrator", Value(name_of(options.integrator)),
                      explained_names() + ", whose light comes by rays that can be told"});
  if (paths && !by_paths)
    throw InputError({FaultKind::conflict, "/paths", Value(*paths),
                      "the integrator path; the rays of " +
                          std::string(name_of(options.integrator)) + " are a tree"});
  const int rays = least_samples(options.samples, options.threshold);
  const int most = options.threshold > 0 && !by_paths ? 16 * rays : rays;
  if (sample >= most)
    throw InputError({FaultKind::out_of_range, "/sample", Value(sample),
                      range_text({.min = 0, .max = most - 1.0}, true) + ", of the pixel's rays"});
}

}  // namespace tia::server
