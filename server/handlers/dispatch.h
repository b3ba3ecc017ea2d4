// Requests to handlers, and whatever comes of them to answers.
#pragma once

#include <exception>
#include <memory>
#include <optional>
#include <string_view>

#include "server/handlers/service.h"
#include "server/http/head.h"
#include "server/http/message.h"

namespace tia::server {

/// The whole service as a function: whatever fails becomes a problem document.
/// Errors: std::bad_alloc where there is no memory even for that one.
Response answer(const Request& request, Service& service);

/// The same answer where it costs next to nothing, for what it sends is there already; else none.
/// Errors: std::bad_alloc.
std::optional<Response> answer_from_memory(const Request& request, Service& service);

/// The answer to a request that failed before it came to answer(). Errors: as answer().
Response refusal(const std::exception_ptr& failure, const Request& request, const Service& service);

/// The word by which a request is counted: its route's path, "none" for what is not here; few,
/// however many targets are asked for.
std::string_view route_label(const Request& request);

/// Whether the request's route, if it has one, is answered at once.
bool is_answered_at_once(const Request& request);

/// How long the body of such a request may be, where its route says so.
std::optional<BodyLimit> body_limit(const Request& request, const Config& config);

/// Where the body of such a request may go while it comes, where it is long; or null.
std::shared_ptr<LongBody> long_body(const Request& request, Service& service);

}  // namespace tia::server
