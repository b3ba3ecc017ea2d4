// The handlers that the routes name, one file an endpoint group.
#pragma once

#include "server/routes.h"

namespace tia::server {

// render_handler.cpp
Response get_render(const Request& request, const std::string&, Service& service);
Response post_render(const Request& request, const std::string&, Service& service);

/// The picture of a plan, from the cache or with a ticket to draw it.
/// Errors: Stopped; InputError; HttpError (busy).
PictureStore::Found picture_of(Plan& plan, const std::string& etag, const std::stop_token& stop,
                               Service& service);

// verify_handler.cpp
Response post_verify(const Request& request, const std::string&, Service& service);

// explain_handler.cpp
Response get_explain(const Request& request, const std::string&, Service& service);
Response post_explain(const Request& request, const std::string&, Service& service);

// scenes_handler.cpp
Response get_scenes(const Request& request, const std::string&, Service& service);
Response get_scene(const Request& request, const std::string& name, Service& service);
Response post_scene(const Request& request, const std::string&, Service& service);
Response get_scene_schema(const Request& request, const std::string&, Service& service);

// health_handler.cpp
Response get_health(const Request& request, const std::string&, Service& service);
Response get_ready(const Request& request, const std::string&, Service& service);
Response get_metrics(const Request& request, const std::string&, Service& service);
Response get_version(const Request& request, const std::string&, Service& service);

// page_handler.cpp
Response get_page(const Request& request, const std::string&, Service& service);
/// A file of the page, or a 404.
Response get_asset(const Request& request, std::string_view path);

}  // namespace tia::server
