// Pictures as files of numbers, not of codes.
#pragma once

#include <stop_token>
#include <string>

#include "core/film/image.h"
#include "server/requests/plan.h"

namespace tia::server {

/// Errors: InputError (conflict) at /depth_range where the picture has no depths, or no infinity.
void check_depth_range(const PictureRequest& asked, IntegratorName integrator);

/// The file in the plan's format, its depths cut to the range that is asked for.
/// Domain: a format that keeps light as it is. Errors: Stopped.
std::string linear_file(const Plan& plan, Image image, const std::stop_token& stop);

}  // namespace tia::server
