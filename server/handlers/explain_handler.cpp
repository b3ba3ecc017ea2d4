// /explain: one pixel or one ray in, what the ray meets out, as JSON.
#include "core/input/json.h"
#include "core/render/explain.h"
#include "server/contract/answers.h"
#include "server/contract/parameters.h"
#include "server/contract/query_parameters.h"
#include "server/handlers/bodies.h"
#include "server/handlers/explanation.h"
#include "server/handlers/handlers.h"
#include "server/requests/map_request.h"
#include "server/requests/radio_request.h"

namespace tia::server {
namespace {

// A cell of a map of radio waves is told as the paths to its centre.
std::string explained_cell(const ExplainRequest& asked, const Service& service,
                           const Requester& requester, Flow& flow) {
  const RenderContext& context = service.rendering;
  const KnownScene scene = found_scene(asked, context, requester).plain;
  const MapGrid grid = grid_of(*scene, *asked.radio, map_limits(context.limits));
  Faults faults;
  const auto coordinate = [&](const char* name, int is, int size) {
    if (is >= size)
      faults.add({FaultKind::out_of_range, Place{}.at(name).pointer(), Value(is),
                  range_text({.unit = "cells", .min = 0, .max = size - 1.0}, true)});
  };
  coordinate("x", *asked.x, grid.width);
  coordinate("y", *asked.y, grid.height);
  faults.raise();
  const RadioQuestion question = paths_question(*asked.radio, grid, *asked.x, *asked.y);
  const Workers workers = context.pool.workers(context.pool.threads(), requester.stop, &flow);
  const RadioAnswer told = radio_paths(*scene, question, radio_limits(context.limits), workers);
  std::string text;
  workers.alone([&] { text = to_json(radio_paths_json(question, told)); });
  return text;
}

ExplainRequest asked_of_body(const Request& request, Service& service) {
  return read_body(request, service, [&] {
    const char* const what = "the parameters as a JSON object, such as {\"x\":320,\"y\":240}";
    return read_described<ExplainRequest>(body_json(request, what, service.config.json_limits()),
                                          {}, request.stop);
  });
}

Response explained(const ExplainRequest& asked, const Request& request, Service& service) {
  check_size(asked.width, asked.height, service.rendering.limits);
  const Requester requester = requester_of(request);
  auto ticket = service.admission.enter({}, requester.client, requester.stop);
  Flow flow{requester.number()};
  flow.became_long = [&] { ticket.turn_heavy(); };
  return {.content_type = "application/json",
          .body = asked.radio ? explained_cell(asked, service, requester, flow)
                              : explanation_of(asked, service, requester, flow),
          .headers = {{"Cache-Control", "no-cache"}}};
}

Response get_explain(const Request& request, const std::string&, Service& service) {
  const auto read = [&] {
    return read_described<ExplainRequest>(query_object<ExplainRequest>(request.query()));
  };
  return explained(read_query(request, service, read), request, service);
}

Response post_explain(const Request& request, const std::string&, Service& service) {
  return explained(asked_of_body(request, service), request, service);
}

Value explained_schema(Definitions& named) {
  return Value::Object{{"anyOf", Value::Array{explanation_schema(named), radio_paths_schema()}}};
}

Answer explanation() {
  return ok(
      "the hits along the ray, and all that makes its colour: the tree of its rays, or of "
      "path the paths of its light and the ways by which it came; of radio what /radio/paths tells",
      media::json, explained_schema, {"Cache-Control"});
}

std::vector<Content> explain_body() {
  return {{media::json,
           schema_for<ExplainRequest>,
           {{"a pixel", R"({"x": 320, "y": 240, "key": "a"})"},
            {"a ray", R"({"ray": {"origin": [0, 0, 0], "direction": [0, 0, -1]}})"}}}};
}

}  // namespace

std::vector<Route> explain_routes() {
  return {{.method = "GET",
           .path = "/explain",
           .name = "get_explain",
           .about = "what the ray of a pixel, or any ray, meets",
           .rights = {Right::explain},
           .pace = Pace::in_turn,
           .handler = get_explain,
           .answers = {explanation()},
           .gives = {media::json},
           .query = query_parameters<ExplainRequest>,
           .examples = {"/explain?x=320&y=240&key=a",
                        "/explain?x=320&y=240&key=a&integrator=path&samples=64&paths=4",
                        "/explain?ray.origin=0,0,0&ray.direction=0,0,-1"}},
          {.method = "POST",
           .path = "/explain",
           .name = "post_explain",
           .about = "the same, parameters as a JSON object",
           .rights = {Right::explain},
           .pace = Pace::in_turn,
           .handler = post_explain,
           .answers = {explanation()},
           .gives = {media::json},
           .body = explain_body()}};
}

}  // namespace tia::server
