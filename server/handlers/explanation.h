// What a pixel or a ray of a scene is told as.
#pragma once

#include <string>

#include "server/handlers/service.h"
#include "server/requests/explain_request.h"

namespace tia::server {

/// The hits and the light of the ray or pixel that is asked for, as JSON.
/// Errors: InputError for a pixel outside of the picture or of no view, and for what has no
/// explanation; those of found_scene and of the rays' budget.
std::string explanation_of(const ExplainRequest& asked, const Service& service,
                           const Requester& requester, Flow& flow);

}  // namespace tia::server
