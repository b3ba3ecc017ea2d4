// /render: parameters in, picture out.
#include <cstdio>

#include "server/handlers.h"
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
  return {.content_type = std::string(picture.media_type),
          .body = std::move(picture.bytes),
          .headers = {{"Server-Timing", server_timing(picture.timing)},
                      {"Tia-Rays", ray_counts(picture.rays)},
                      {"Cache-Control", "no-cache"}}};
}

// What a client need not know, but whoever runs the server may.
void log(const Picture& picture, const Request& request) {
  if (picture.degenerate > 0)
    std::fprintf(stderr, "request %s: %zu triangles without area are ignored\n", request.id.c_str(),
                 picture.degenerate);
}

Response render_picture(const Value& parameters, Stopwatch watch, const Request& request,
                        Service& service) {
  const auto asked = read_described<PictureRequest>(parameters);
  const double read_ms = watch.lap_ms();
  Picture picture = draw(asked, service.studio, service.stopping);
  picture.timing.parse += read_ms;
  log(picture, request);
  return picture_response(std::move(picture));
}

// HEAD checks what can be checked without a ray, and renders nothing.
Response head_of_picture(const PictureRequest& asked, const Service& service) {
  static_cast<void>(plan_of(asked, service.studio));
  return {.content_type = std::string(media_type_of(asked.format)), .body = "", .unsized = true};
}

}  // namespace

Response get_render(const Request& request, const std::string&, Service& service) {
  const Stopwatch watch;
  const Value parameters = query_object<PictureRequest>(request.query());
  if (request.is_head())
    return head_of_picture(read_described<PictureRequest>(parameters), service);
  return render_picture(parameters, watch, request, service);
}

Response post_render(const Request& request, const std::string&, Service& service) {
  const Stopwatch watch;
  const Value parameters =
      body_json(request, "the parameters as a JSON object, such as {\"key\":\"a\"}");
  return render_picture(parameters, watch, request, service);
}

}  // namespace tia::server
