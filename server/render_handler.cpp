// /render: parameters in, picture out.
#include <algorithm>
#include <cstdio>

#include "core/input/json.h"
#include "server/handlers.h"
#include "server/problem.h"
#include "server/stopwatch.h"
#include "server/text_form.h"

namespace tia::server {
namespace {

// A query's names and values are written as forms write them, a space as +.
std::string form_decode(std::string text, std::string_view pointer = "") {
  std::replace(text.begin(), text.end(), '+', ' ');
  return percent_decode(text, pointer);
}

// name=value&name=value as the JSON object that a POST would send.
Value query_object(std::string_view query) {
  Value::Object object;
  while (!query.empty()) {
    const std::string_view pair = query.substr(0, query.find('&'));
    query.remove_prefix(std::min(query.size(), pair.size() + 1));
    if (pair.empty()) continue;
    const auto equals = std::min(pair.find('='), pair.size());
    const std::string name = form_decode(std::string(pair.substr(0, equals)));
    const std::string place = Place{}.at(name).pointer();
    const std::string text =
        form_decode(std::string(pair.substr(std::min(equals + 1, pair.size()))), place);
    if (find(object, name) != nullptr)
      throw InputError({FaultKind::malformed, place, Value(text), "each parameter once"});
    object.emplace_back(name, field_from_text<PictureRequest>(name, text));
  }
  return object;
}

// A body that starts with { is JSON whatever its declared type: curl -d declares a form.
Value body_object(const Request& request) {
  if (!request.query().empty())
    throw InputError({FaultKind::conflict, "", Value(request.query()),
                      "with POST all parameters in the body, none in the URL"});
  const auto start = request.body.find_first_not_of(" \t\r\n");
  const bool declared_json = request.header("Content-Type").find("json") != std::string_view::npos;
  if (start == std::string::npos || (request.body[start] != '{' && !declared_json))
    throw HttpError("media-type", "send the parameters as a JSON object, such as {\"key\":\"a\"}");
  return parse_json(request.body);
}

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

Response render_picture(const Value& parameters, Stopwatch watch, Service& service) {
  const auto asked = read_described<PictureRequest>(parameters);
  const double read_ms = watch.lap_ms();
  Picture picture = draw(asked, service.studio, service.stopping);
  picture.timing.parse += read_ms;
  return picture_response(std::move(picture));
}

// HEAD checks what can be checked without a ray, and renders nothing.
Response head_of_picture(const PictureRequest& asked, const Service& service) {
  check_size(asked.width, asked.height, service.studio.limits);
  static_cast<void>(scene_of(asked, service.studio.gallery));
  return {.content_type = std::string(media_type_of(asked.format)), .body = "", .unsized = true};
}

}  // namespace

Response get_render(const Request& request, const std::string&, Service& service) {
  const Stopwatch watch;
  const Value parameters = query_object(request.query());
  if (request.is_head())
    return head_of_picture(read_described<PictureRequest>(parameters), service);
  return render_picture(parameters, watch, service);
}

Response post_render(const Request& request, const std::string&, Service& service) {
  const Stopwatch watch;
  return render_picture(body_object(request), watch, service);
}

}  // namespace tia::server
