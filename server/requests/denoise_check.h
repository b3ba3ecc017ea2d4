// Whether a picture can be denoised.
#pragma once

#include "server/requests/plan.h"

namespace tia::server {

/// Errors: InputError (conflict, at /denoise) where that is asked for and there is no noise to be
/// taken off, nothing to tell it by, or a layer of the samples beside, whose noise is its own.
void check_denoise(const Plan& plan);

}  // namespace tia::server
