// A film that plays while it is drawn.
#pragma once

#include "server/handlers/live_pictures.h"
#include "server/requests/film_plan.h"

namespace tia::server {

/// Shows the film's pictures, each at its time from the first one on. The one that is drawn next is
/// the first whose time is not over before it can be there, as long as the last one took: so what
/// would come late is left out, but for the last one. Errors: as LivePictures.
void play(FilmRequest& asked, const FilmPlan& film, const RenderContext& context,
          const Requester& requester, LivePictures& pictures);

}  // namespace tia::server
