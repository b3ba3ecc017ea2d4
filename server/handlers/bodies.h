// Who asks, and what they have sent, read as long work.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "server/handlers/service.h"
#include "server/http/message.h"
#include "server/operation/memory_costs.h"
#include "server/requests/recipe.h"

namespace tia::server {

/// Whom the request is from.
Requester requester_of(const Request& request);

/// What to read the request's body needs, as JSON text.
LongWork::Need body_need(const Request& request, const Service& service);

/// Whether a query holds an object or a list, and what to read it needs.
bool holds_json(std::string_view query);
LongWork::Need query_need(const Request& request, const Service& service);

/// Reads the body. Returns: what read() does. Errors: as LongWork.
template <class Read>
auto read_body(const Request& request, Service& service, const Read& read) {
  return service.rendering.long_work(body_need(request, service), requester_of(request), read);
}

/// Reads the query: as long work where it holds JSON, such as a whole scene, which may be as much
/// of it as in a body. Returns: what read() does. Errors: as LongWork, and whatever it throws.
template <class Read>
auto read_query(const Request& request, Service& service, const Read& read) {
  if (!holds_json(request.query())) return read();
  return service.rendering.long_work(query_need(request, service), requester_of(request), read);
}

/// Reads the recipe of the picture that the body is. Returns: what read(recipe) does.
/// Errors: as LongWork, recipe_text_in and read_recipe.
template <class Read>
auto read_recipe_of_body(const Request& request, Service& service, const Read& read) {
  const Config& config = service.config;
  const Requester requester = requester_of(request);
  constexpr const char* what = "the picture's recipe";
  const std::string text =
      service.rendering.long_work({request.body.size(), config.max_body_bytes, what}, requester,
                                  [&] { return recipe_text_in(request.body, config); });
  const std::int64_t memory = memory_for_text(text.size(), config.json_limits().values);
  return service.rendering.long_work({text.size(), memory, what}, requester,
                                     [&] { return read(read_recipe(text, config, request.stop)); });
}

}  // namespace tia::server
