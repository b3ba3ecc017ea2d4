// /render: parameters in, picture out.
#include <cstdio>

#include "server/accept.h"
#include "server/etag.h"
#include "server/handlers.h"
#include "server/headers.h"
#include "server/parameters.h"
#include "server/recipe.h"
#include "server/stopwatch.h"

namespace tia::server {
namespace {

std::string server_timing(const Timing& t) {
  char text[160];
  std::snprintf(text, sizeof text,
                "queue;dur=%.3f, parse;dur=%.3f, build;dur=%.3f, trace;dur=%.3f, encode;dur=%.3f",
                t.queue, t.parse, t.build, t.trace, t.encode);
  return text;
}

std::string ray_counts(const RayCounts& rays) {
  return "primary=" + std::to_string(rays.primary) + ", shadow=" + std::to_string(rays.shadow) +
         ", reflection=" + std::to_string(rays.reflection) +
         ", refraction=" + std::to_string(rays.refraction);
}

// RFC 9211, with this server as the cache and the tracer behind it.
std::string cache_status(const PictureStore::Found& found) {
  std::string status = "Tia; ";
  if (found.source == Source::stored) return status + "hit";
  status += found.source == Source::joined ? "fwd=miss; collapsed" : "fwd=miss";
  return found.kept ? status + "; stored" : status;
}

/// What is asked for, and whether Accept has chosen the format.
struct Asked {
  PictureRequest picture;
  bool accepted = false;
};

// Where no format is asked for, Accept chooses it. The JSON tree ends here, not with the picture.
Asked asked_in(Value parameters, const Request& request) {
  const bool accepted = choose_format(parameters, request);
  return {read_described<PictureRequest>(parameters, {}, request.stop), accepted};
}

Value recipe_request(const Request& request, const Config& config) {
  refuse_query(request);
  Recipe recipe = recipe_in(request.body, config, request.stop);
  check_version(recipe);
  return std::move(recipe.request);
}

Asked asked_in_body(const Request& request, Service& service) {
  const auto ticket = service.admission.read(request.body.size(), request.stop);
  if (is_png(request.body)) return asked_in(recipe_request(request, service.config), request);
  return asked_in(body_json(request,
                            "the parameters as a JSON object, such as {\"key\":\"a\"}, or a PNG "
                            "that this server has sent",
                            service.config.json_limits()),
                  request);
}

/// What is said of a picture, whether it is sent or not.
Headers validators(const std::string& etag, const Asked& asked) {
  const bool for_good = asked.picture.v.has_value();
  Headers headers{{"ETag", etag},
                  {"Cache-Control", for_good ? "public, max-age=31536000, immutable" : "no-cache"}};
  if (asked.accepted) add_vary(headers, "Accept");
  return headers;
}

// A picture that was not drawn for this request took it no time, but its rays are told again.
Response picture_response(const PictureStore::Found& found, double parse_ms, double wait_ms) {
  const Picture& picture = *found.picture;
  Timing timing = found.source == Source::drawn ? picture.timing : Timing{};
  if (found.source == Source::joined) timing.queue = wait_ms;
  timing.parse = parse_ms;
  Response response{.content_type = std::string(picture.media_type),
                    .body = picture.bytes,
                    .headers = {{"Server-Timing", server_timing(timing)},
                                {"Tia-Rays", ray_counts(picture.rays)},
                                {"Cache-Status", cache_status(found)}}};
  for (const auto& [name, value] : response.headers) response.log.emplace_back(name, value);
  // What a client need not know, but whoever runs the server may.
  if (picture.degenerate > 0)
    response.log.emplace_back("triangles without area", static_cast<double>(picture.degenerate));
  return response;
}

// HEAD and If-None-Match need no ray: what the picture is called is known.
Response rendered(const Asked& asked, Stopwatch watch, const Request& request, Service& service) {
  Plan plan = plan_of(asked.picture, service.studio);
  const std::string etag = etag_of(plan.recipe);
  const double parse_ms = watch.lap_ms();
  Headers headers = validators(etag, asked);
  Response response{.content_type = std::string(media_type_of(plan.format)), .body = ""};
  if (request.method != "POST" && has_already(request, etag)) {
    response = {.status = 304, .content_type = "", .body = ""};
    headers.emplace_back("Cache-Status", "Tia; hit; detail=not-modified");
  } else if (request.is_head()) {
    response.unsized = true;
  } else {
    const auto found = picture_of(plan, etag, request.stop, service);
    response = picture_response(found, parse_ms, watch.lap_ms());
  }
  response.headers.insert(response.headers.end(), headers.begin(), headers.end());
  return response;
}

}  // namespace

PictureStore::Found picture_of(Plan& plan, const std::string& etag, const std::stop_token& stop,
                               Service& service) {
  const auto drawn = [&](const std::stop_token& given_up) {
    Stopwatch watch;
    auto ticket = service.admission.enter(plan.rays(), given_up);
    const double queue_ms = watch.lap_ms();
    plan.options.spent = [&](std::int64_t rays, std::int64_t tests) {
      ticket.has_done(rays, tests);
    };
    Picture picture = draw(plan, service.studio, given_up);
    picture.timing.queue = queue_ms;
    service.metrics.count(picture);
    return picture;
  };
  return service.pictures.get(etag, drawn, stop);
}

Response get_render(const Request& request, const std::string&, Service& service) {
  const Stopwatch watch;
  return rendered(asked_in(query_object<PictureRequest>(request.query()), request), watch, request,
                  service);
}

Response post_render(const Request& request, const std::string&, Service& service) {
  const Stopwatch watch;
  return rendered(asked_in_body(request, service), watch, request, service);
}

}  // namespace tia::server
