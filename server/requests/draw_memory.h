// What a picture may take of memory while it is drawn.
#pragma once

#include <cstdint>

#include "server/requests/plan.h"

namespace tia::server {

/// All that the picture may take at most, its scene aside; more where it is watched. Space/units:
/// bytes.
std::int64_t memory_of(const Plan& plan, bool is_watched);

}  // namespace tia::server
