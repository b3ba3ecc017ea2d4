// What jobs have come to: /jobs/{id}/result, /results/{n}, /parts.
#pragma once

#include <vector>

#include "server/contract/route.h"

namespace tia::server {

std::vector<Route> job_result_routes(const Segment& id);

}  // namespace tia::server
