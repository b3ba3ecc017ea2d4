#include "core/scene/limits.h"

namespace tia {

void check_size(std::int64_t width, std::int64_t height, const Limits& limits) {
  const std::int64_t pixels = width * height;
  if (pixels <= limits.max_pixels) return;
  throw InputError({FaultKind::limit, "/width",
                    Value(std::to_string(width) + " x " + std::to_string(height)),
                    "width x height of at most " + std::to_string(limits.max_pixels) +
                        " pixels (option TIA_MAX_PIXELS)"});
}

void check_rays(std::int64_t pixels, std::int64_t samples, const Limits& limits) {
  if (samples <= 0 || pixels <= limits.max_rays / samples) return;
  throw too_many_rays(std::to_string(pixels) + " pixels of " + std::to_string(samples) + " samples",
                      limits.max_rays);
}

InputError too_many_rays(const std::string& got, std::int64_t max_rays) {
  return InputError({FaultKind::limit, "/samples", Value(got),
                     "at most " + std::to_string(max_rays) + " rays (option TIA_MAX_RAYS)"});
}

InputError too_many_children(std::int64_t max_rays) {
  return InputError({FaultKind::limit, "/max_depth",
                     Value("a picture of more, mirrored and refracted ones above all"),
                     "at most " + std::to_string(max_rays) + " rays (option TIA_MAX_RAYS)"});
}

InputError too_much_work(std::int64_t max_work) {
  return InputError({FaultKind::limit, "/scene", Value("a scene that costs more"),
                     "at most " + std::to_string(max_work) +
                         " tests of rays against boxes and surfaces (option TIA_MAX_WORK); what "
                         "overlaps is tried one by one"});
}

}  // namespace tia
