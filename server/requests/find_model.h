// Models that requests name.
#pragma once

#include <string>

#include "server/requests/render_context.h"

namespace tia::server {

/// The model of that id, or null. Errors: as ModelStore::find.
SharedModel find_model(const std::string& id, const RenderContext& context,
                       const Requester& requester);

}  // namespace tia::server
