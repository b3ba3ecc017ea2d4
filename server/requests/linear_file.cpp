#include "server/requests/linear_file.h"

#include <limits>
#include <stdexcept>
#include <utility>

#include "core/film/hdr.h"
#include "core/film/pfm.h"
#include "core/film/tiff.h"

namespace tia::server {
namespace {

void keep_within(const std::array<double, 2>& range, Image& image) {
  for (float& depth : image.rgb) {
    const auto exact = static_cast<double>(depth);
    if (exact < range[0]) depth = 0;
    else if (exact > range[1]) depth = std::numeric_limits<float>::infinity();
  }
}

}  // namespace

void check_depth_range(const PictureRequest& asked, IntegratorName integrator) {
  if (!asked.depth_range) return;
  if (display_of(integrator) != FeatureDisplay::depth || holds_codes(asked.format))
    throw InputError({FaultKind::conflict, "/depth_range", write_value(*asked.depth_range),
                      "integrator depth or planar_depth, in the format tiff or pfm"});
}

std::string linear_file(const Plan& plan, Image image, const std::stop_token& stop) {
  if (plan.asked->depth_range) keep_within(*plan.asked->depth_range, image);
  switch (plan.format) {
    case Format::pfm: return encode_pfm(image, stop);
    case Format::hdr: return encode_hdr(std::move(image), stop);
    case Format::tiff: return encode_tiff(image, row_of(plan.options.integrator).channels, stop);
    case Format::png:
    case Format::exr:
    case Format::zip: break;
  }
  throw std::logic_error("a format of its own");
}

}  // namespace tia::server
