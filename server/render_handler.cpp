// /render: parameters in, picture out.
#include <cstdio>

#include "server/accept.h"
#include "server/handlers.h"
#include "server/headers.h"
#include "server/parameters.h"
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

Response picture_response(Picture&& picture) {
  Response response{.content_type = std::string(picture.media_type),
                    .body = std::move(picture.bytes),
                    .headers = {{"Server-Timing", server_timing(picture.timing)},
                                {"Tia-Rays", ray_counts(picture.rays)},
                                {"Cache-Control", "no-cache"}}};
  for (const auto& [name, value] : response.headers)
    if (name != "Cache-Control") response.log.emplace_back(name, value);
  // What a client need not know, but whoever runs the server may.
  if (picture.degenerate > 0)
    response.log.emplace_back("triangles without area", static_cast<double>(picture.degenerate));
  return response;
}

/// What is asked for, and whether Accept has chosen the format.
struct Asked {
  PictureRequest picture;
  bool accepted = false;
};

// Where no format is asked for, Accept chooses it. The JSON tree ends here, not with the picture.
Asked asked_in(Value parameters, const Request& request) {
  const bool accepted = choose_format(parameters, request);
  return {read_described<PictureRequest>(parameters), accepted};
}
Asked asked_in_body(const Request& request, Service& service) {
  const auto ticket = service.admission.read(request.body.size(), request.stop);
  return asked_in(body_json(request, "the parameters as a JSON object, such as {\"key\":\"a\"}",
                            service.config.json_limits()),
                  request);
}

// The whole service in one function: parameters -> plan -> ticket -> picture -> answer.
Response render_picture(const PictureRequest& asked, Stopwatch watch, const Request& request,
                        Service& service) {
  Plan plan = plan_of(asked, service.studio);
  const double parse_ms = watch.lap_ms();
  auto ticket = service.admission.enter(plan.rays(), request.stop);
  const double queue_ms = watch.lap_ms();
  plan.options.spent = [&](std::int64_t rays, std::int64_t tests) { ticket.has_done(rays, tests); };
  Picture picture = draw(plan, service.studio, request.stop);
  picture.timing.parse = parse_ms;
  picture.timing.queue = queue_ms;
  service.metrics.count(picture);
  return picture_response(std::move(picture));
}

// HEAD checks what can be checked without a ray, and renders nothing.
Response head_of_picture(const PictureRequest& asked, const Service& service) {
  static_cast<void>(plan_of(asked, service.studio));
  return {.content_type = std::string(media_type_of(asked.format)), .body = "", .unsized = true};
}

Response rendered(const Asked& asked, Stopwatch watch, const Request& request, Service& service) {
  Response response = request.is_head() ? head_of_picture(asked.picture, service)
                                        : render_picture(asked.picture, watch, request, service);
  if (asked.accepted) add_vary(response.headers, "Accept");
  return response;
}

}  // namespace

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
