// The handlers that the routes name, one file an endpoint group.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "server/contract/contract.h"
#include "server/handlers/service.h"
#include "server/http/message.h"
#include "server/requests/plan.h"

namespace tia::server {

// render_handler.cpp
Response get_render(const Request& request, const std::string&, Service& service);
Response post_render(const Request& request, const std::string&, Service& service);

/// What GET /render would answer, where its target is known and its picture kept, or not to be sent
/// again. None: somebody has to look into it.
std::optional<Response> known_picture(const Request& request, Service& service);

/// The picture of a plan, from the cache or with a ticket to draw it.
/// Errors: Stopped; InputError; HttpError (busy, too-large).
PictureStore::Found picture_of(Plan& plan, const std::string& etag, const Asker& asker,
                               Service& service);

// verify_handler.cpp
Response post_verify(const Request& request, const std::string&, Service& service);
Value verdict_schema(Definitions& named);

// explain_handler.cpp
Response get_explain(const Request& request, const std::string&, Service& service);
Response post_explain(const Request& request, const std::string&, Service& service);

// scenes_handler.cpp
Response get_scenes(const Request& request, const std::string&, Service& service);
Response get_scene(const Request& request, const std::string& name, Service& service);
Response post_scene(const Request& request, const std::string&, Service& service);
Response delete_scene(const Request& request, const std::string& id, Service& service);
Response get_scene_schema(const Request& request, const std::string&, Service& service);
Value kept_scene_schema(Definitions& named);

// health_handler.cpp
Response get_health(const Request& request, const std::string&, Service& service);
Response get_ready(const Request& request, const std::string&, Service& service);
Response get_metrics(const Request& request, const std::string&, Service& service);
Response get_version(const Request& request, const std::string&, Service& service);
Value healthy_schema(Definitions& named);
Value ready_schema(Definitions& named);
Value unready_schema(Definitions& named);
Value version_schema(Definitions& named);

// page_handler.cpp
Response get_page(const Request& request, const std::string&, Service& service);
Response get_docs(const Request& request, const std::string&, Service& service);
Response get_page_file(const Request& request, const std::string&, Service& service);
bool is_page_file(std::string_view path);
/// The folders of the page's files, "/" first, each with a slash at its end.
const std::vector<std::string>& page_folders();
/// The names of a folder's files.
std::vector<std::string_view> page_files(std::string_view folder);
/// Their media types.
std::vector<Content> page_file_contents(std::string_view folder);

// documents_handler.cpp
Response get_openapi(const Request& request, const std::string&, Service& service);
Response get_problem(const Request& request, const std::string& type, Service& service);

}  // namespace tia::server
