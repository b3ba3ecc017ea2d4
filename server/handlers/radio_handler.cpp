// /radio/paths: a scene with antennas in; out come the ways of radio waves between them.
#include "core/input/json.h"
#include "server/contract/answers.h"
#include "server/contract/parameters.h"
#include "server/handlers/bodies.h"
#include "server/handlers/handlers.h"
#include "server/requests/radio_request.h"

namespace tia::server {
namespace {

RadioPathsRequest asked_paths(const Request& request, Service& service) {
  refuse_query(request);
  return read_body(request, service, [&] {
    const char* const what = "the parameters as a JSON object, with scene, transmitters, receivers";
    return read_described<RadioPathsRequest>(body_json(request, what, service.config.json_limits()),
                                             {}, request.stop);
  });
}

Response post_radio_paths(const Request& request, const std::string&, Service& service) {
  const RadioPathsRequest asked = asked_paths(request, service);
  const Requester requester = requester_of(request);
  const RenderContext& context = service.rendering;
  ViewRequest view;
  view.scene = asked.scene;
  const KnownScene scene = scene_of(view, context, requester);
  auto ticket = service.admission.enter({}, requester.client, requester.stop);
  Flow flow{requester.number()};
  flow.became_long = [&] { ticket.turn_heavy(); };
  const Workers workers = context.pool.workers(context.pool.threads(), requester.stop, &flow);
  const RadioAnswer answer = radio_paths(*scene, asked, radio_limits(context.limits), workers);
  std::string text;
  workers.alone([&] { text = to_json(radio_paths_json(asked, answer)); });
  return {.content_type = "application/json",
          .body = std::move(text),
          .headers = {{"Cache-Control", "no-cache"}}};
}

Value radio_answer_schema(Definitions&) { return radio_paths_schema(); }

std::vector<Content> radio_body() {
  return {{media::json, schema_for<RadioPathsRequest>, {{"two antennas above the ground", R"({
  "scene": {"objects": [{"name": "ground", "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0],
             "material": {"radio": {"type": "itu", "name": "medium_dry_ground"}}}]},
  "transmitters": [{"name": "mast", "position": [0, 10, 0]}],
  "receivers": [{"name": "phone", "position": [200, 1.5, 0]}],
  "frequency_hz": 2.4e9})"}}}};
}

}  // namespace

std::vector<Route> radio_routes() {
  return {{.method = "POST",
           .path = "/radio/paths",
           .name = "post_radio_paths",
           .about = "the ways of radio waves between transmitters and receivers among a scene's "
                    "bodies, and what they carry",
           .rights = {Right::render},
           .pace = Pace::in_turn,
           .handler = post_radio_paths,
           .answers = {ok("the paths of every pair, the shortest first, with what was assumed",
                          media::json, radio_answer_schema, {"Cache-Control"})},
           .gives = {media::json},
           .body = radio_body()}};
}

}  // namespace tia::server
