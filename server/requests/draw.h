// The pipeline that /render and `tia render` share:
//   PictureRequest -> Plan -> World -> film -> bytes
#pragma once

#include <stop_token>

#include "server/operation/requester.h"
#include "server/requests/onlooker.h"
#include "server/requests/plan.h"
#include "server/requests/render_context.h"
#include "server/stores/picture.h"

namespace tia::server {

/// Errors: InputError; as scene_of. The plan may refer to the request.
Plan plan_of(const PictureRequest& asked, const RenderContext& context, const Requester& requester);
/// The same of a scene that has been found: found_scene(asked, context, requester).
Plan plan_of(const PictureRequest& asked, const FoundScene& found, const RenderContext& context,
             const Requester& requester);

/// The same without recipe and the names by it, which take longer than all that is checked: of what
/// is not drawn yet.
Plan checked_plan_of(const PictureRequest& asked, const RenderContext& context,
                     const Requester& requester);

/// Makes the picture, which carries its recipe if it is a PNG. Before each step it reserves the
/// memory that it may take. Errors: InputError; Stopped; as MemoryClaim::reserve;
/// what the onlooker throws.
Picture draw(const Plan& plan, const RenderContext& context, const std::stop_token& stop,
             const Onlooker* onlooker = nullptr);

}  // namespace tia::server
