// The endpoint groups, one file each.
#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "server/contract/route.h"
#include "server/handlers/service.h"
#include "server/http/message.h"
#include "server/operation/shared_flow.h"
#include "server/operation/timing.h"
#include "server/requests/plan.h"

namespace tia::server {

// The routes that each group answers, in the file of its name.
std::vector<Route> render_routes();
std::vector<Route> film_routes();
std::vector<Route> live_routes();
std::vector<Route> picture_routes();
std::vector<Route> verify_routes();
std::vector<Route> explain_routes();
std::vector<Route> compare_routes();
std::vector<Route> scene_routes();
std::vector<Route> simulate_routes();
std::vector<Route> radio_routes();
std::vector<Route> map_routes();
std::vector<Route> gallery_model_routes();
std::vector<Route> model_routes();
std::vector<Route> still_routes();
std::vector<Route> job_routes();
std::vector<Route> operation_routes();
std::vector<Route> document_routes();
std::vector<Route> page_routes();

/// What GET /render would answer, where its target is known and its picture kept, or not to be sent
/// again. None: somebody has to look into it.
std::optional<Response> known_picture(const Request& request, Service& service);

/// The picture that a form asks for, as Drake's client sends it; `watch` has run since the request
/// came. Errors: as read_drake_form, drake_picture, ModelStore::look_into, rendered; HttpError.
Response rendered_form(const Request& request, std::string_view boundary, Stopwatch watch,
                       Service& service);

/// The picture of a plan, from the cache or with a ticket to draw it.
/// Who sees it meanwhile has it drawn as heavy work, however few its rays are.
/// Errors: Stopped; InputError; HttpError (busy, too-large).
PictureStore::Found picture_of(Plan& plan, const std::string& etag, const Requester& requester,
                               Service& service, const Showing::See& see = nullptr);

/// What who waits for what others draw brings: a place in the queue.
PictureStore::Wish waiting_wish(const Requester& requester, const Showing::See& see,
                                Service& service);

/// How a picture is drawn where nobody else has: within the flow, showing what there is by then.
using DrawShared =
    std::function<Picture(SharedFlow& flow, Showing& showing, const std::stop_token& stop)>;

/// The picture of that tag, from the cache or drawn once for all who ask for it at the same time.
/// Errors: PictureStore::get's.
PictureStore::Found drawn_once(const std::string& etag, const Requester& requester,
                               Service& service, const Showing::See& see, const DrawShared& draw);

}  // namespace tia::server
