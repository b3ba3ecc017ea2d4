#include "server/handlers/dispatch.h"

#include <new>

#include "core/models/multipart.h"
#include "server/access/sites.h"
#include "server/contract/problem.h"
#include "server/handlers/handlers.h"
#include "server/handlers/route_table.h"
#include "server/http/headers.h"
#include "server/operation/log.h"
#include "server/requests/accept.h"

namespace tia::server {
namespace {

// Whether the path fits the route; `name` becomes what its {} stands for.
bool matches(const Route& route, std::string_view path, std::string_view& name);

// A path that ends with a second {}: `name` becomes all from the first one on.
bool matches_two(const Route& route, std::string_view path, std::string_view& name) {
  const auto slash = path.rfind('/');
  if (slash == path.npos || slash + 1 == path.size()) return false;
  Route front = route;
  front.path.remove_suffix(3);
  front.last_segment = {};
  if (!matches(front, path.substr(0, slash), name)) return false;
  name = path.substr(static_cast<std::size_t>(name.data() - path.data()));
  return true;
}

bool matches(const Route& route, std::string_view path, std::string_view& name) {
  if (!route.last_segment.name.empty()) return matches_two(route, path, name);
  const std::size_t open = route.path.find("{}");
  if (open == route.path.npos) return path == route.path;
  const std::string_view stem = route.path.substr(0, open), end = route.path.substr(open + 2);
  if (!path.starts_with(stem) || !path.ends_with(end) || path.size() <= stem.size() + end.size())
    return false;
  name = path.substr(stem.size(), path.size() - stem.size() - end.size());
  return name.find('/') == name.npos && (route.has == nullptr || route.has(path));
}

// What may be done with a path (RFC 9110, 9.3.7), or with some path of this server.
Response options(const std::string& allow) {
  return {.status = 204, .content_type = "", .body = "", .headers = {{"Allow", allow}}};
}

Response dispatch(const Request& request, Service& service) {
  if (request.method == "OPTIONS" && request.target == "*")
    return options("GET, HEAD, POST, DELETE, OPTIONS");
  if (request.target.size() > longest_target) throw uri_too_long();
  check_sites(request, service.config);
  const std::string_view method = request.is_head() ? "GET" : std::string_view(request.method);
  std::string allow;
  for (const Route& route : routes()) {
    std::string_view name;
    if (!matches(route, request.path(), name)) continue;
    if (route.method == method) {
      service.access.admit(request, route.rights);
      if (!route.gives.empty()) static_cast<void>(preferred_type(request, route.gives));
      return route.handler(request, percent_decode(name), service);
    }
    if (allow.find(route.method) != allow.npos) continue;  // of a path that fits another one, too
    allow += (allow.empty() ? "" : ", ") + std::string(route.method);
    if (route.method == "GET") allow += ", HEAD";
  }
  if (allow.empty()) throw HttpError("not-found", "no such path");
  allow += ", OPTIONS";
  if (method == "OPTIONS") return options(allow);
  throw HttpError("method", request.method + " is not for this path; allowed: " + allow,
                  {{"Allow", allow}});
}

// What every answer carries, whatever made it.
Response dressed(Response response, const Request& request, const Service& service) {
  guard(response);
  if (request.trace) response.headers.emplace_back("traceparent", request.trace->traceparent());
  share(response, request, service.config.cors_origins);
  service.access.tell(response, request);
  return response;
}

Response finished(Response response, const Request& request, const Service& service) {
  response.headers.emplace_back("X-Request-Id", request.id);
  return dressed(std::move(response), request, service);
}

// What of a failure is for the log goes there.
Response logged(Response response, const Request& request, const Service& service) {
  if (!response.failure.empty()) log_failure(request.id, response.failure);
  return dressed(std::move(response), request, service);
}

Response answer_or_refusal(const Request& request, MemoryClaim& claim, Service& service) {
  try {
    return finished(dispatch(request, service), request, service);
  } catch (const std::bad_alloc&) {
    claim.settle();  // what was freed on the way here is there for the refusal's words
    // Nobody could make room while it was allocated: who comes again finds it.
    if (claim.was_refused()) service.memory.make_room(2 * claim.most_used());
    const auto failure =
        claim.was_refused() ? std::make_exception_ptr(claim.refusal()) : std::current_exception();
    return refusal(failure, request, service);
  } catch (...) {
    return refusal(std::current_exception(), request, service);
  }
}

const Route* route_of(const Request& request) {
  const std::string_view method = request.is_head() ? "GET" : std::string_view(request.method);
  std::string_view name;
  for (const Route& route : routes())
    if (route.method == method && matches(route, request.path(), name)) return &route;
  return nullptr;
}

}  // namespace

Response answer(const Request& request, Service& service) {
  MemoryClaim claim(service.memory, share_of(request.peer));
  const ClaimScope scope(&claim);
  Response response = answer_or_refusal(request, claim, service);
  if (claim.most_used() > 0)
    response.log.emplace_back("memory_bytes", static_cast<double>(claim.most_used()));
  return response;
}

std::optional<Response> answer_from_memory(const Request& request, Service& service) {
  try {
    check_sites(request, service.config);
  } catch (const HttpError&) {
    return std::nullopt;  // it is refused where all are
  }
  auto response = known_picture(request, service);
  if (!response || !service.access.takes(request, route_of(request)->rights)) return std::nullopt;
  return finished(std::move(*response), request, service);
}

Response refusal(const std::exception_ptr& failure, const Request& request,
                 const Service& service) {
  try {
    return logged(problem_response(failure, request), request, service);
  } catch (const std::bad_alloc&) {  // perhaps there is memory for fewer words
    return logged(problem_response(std::current_exception(), request), request, service);
  }
}

std::string_view route_label(const Request& request) {
  std::string_view name;
  for (const Route& route : routes())
    if (matches(route, request.path(), name)) return route.path;
  return "none";
}

bool is_answered_at_once(const Request& request) {
  const Route* const route = route_of(request);
  return route == nullptr || route->pace == Pace::at_once;
}

std::optional<BodyLimit> body_limit(const Request& request, const Config& config) {
  const Route* const route = route_of(request);
  if (route == nullptr) return std::nullopt;
  const bool is_form = route->form_limit != nullptr && boundary_of(request.header("Content-Type"));
  const auto own = is_form ? route->form_limit : route->body_limit;
  return own == nullptr ? std::nullopt : std::optional(own(config));
}

std::shared_ptr<LongBody> long_body(const Request& request, Service& service) {
  const Route* const route = route_of(request);
  return route != nullptr && route->keeps_body ? service.models.begin() : nullptr;
}

}  // namespace tia::server
