// THE LIST of routes.
#pragma once

#include <vector>

#include "server/contract/route.h"

namespace tia::server {

/// All routes. Where two fit a path, the first is meant.
const std::vector<Route>& routes();

}  // namespace tia::server
