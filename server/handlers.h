// The handlers that the routes name, one file an endpoint group.
#pragma once

#include "server/operation/memory_costs.h"
#include "server/recipe.h"
#include "server/routes.h"

namespace tia::server {

// render_handler.cpp
Response get_render(const Request& request, const std::string&, Service& service);
Response post_render(const Request& request, const std::string&, Service& service);

/// What GET /render would answer, where its target is known and its picture kept, or not to be sent
/// again. None: somebody has to look into it.
std::optional<Response> known_picture(const Request& request, Service& service);

/// Whom the request is from.
Asker asker_of(const Request& request);

/// What to read the request's body needs, as JSON text.
LongWork::Need body_need(const Request& request, const Service& service);

/// Reads the body. Returns: what read() does. Errors: as LongWork.
template <class Read>
auto read_body(const Request& request, Service& service, const Read& read) {
  return service.long_work(body_need(request, service), asker_of(request), read);
}

/// Reads the recipe of the picture that the body is. Returns: what read(recipe) does.
/// Errors: as LongWork, recipe_text_in and read_recipe.
template <class Read>
auto read_recipe_of_body(const Request& request, Service& service, const Read& read) {
  const Config& config = service.config;
  const Asker asker = asker_of(request);
  constexpr const char* what = "the picture's recipe";
  const std::string text =
      service.long_work({request.body.size(), config.max_body_bytes, what}, asker,
                        [&] { return recipe_text_in(request.body, config); });
  const std::int64_t memory = memory_for_text(text.size(), config.json_limits().values);
  return service.long_work({text.size(), memory, what}, asker,
                           [&] { return read(read_recipe(text, config, request.stop)); });
}

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
Response get_docs(const Request& request, const std::string&, Service& service);
Response get_problem(const Request& request, const std::string& type, Service& service);

}  // namespace tia::server
