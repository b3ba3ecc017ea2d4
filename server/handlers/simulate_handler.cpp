// /simulate: a scene with physics in; out comes the scene with its bodies' motion as tracks, and
// what happened on the way.
#include "core/input/json.h"
#include "server/contract/answers.h"
#include "server/contract/parameters.h"
#include "server/handlers/bodies.h"
#include "server/handlers/handlers.h"
#include "server/requests/simulate_request.h"

namespace tia::server {
namespace {

SimulateRequest asked_simulation(const Request& request, Service& service) {
  refuse_query(request);
  return read_body(request, service, [&] {
    const char* const what = "the parameters as a JSON object, such as {\"scene\":\"newcomer\"}";
    return read_described<SimulateRequest>(body_json(request, what, service.config.json_limits()),
                                           {}, request.stop);
  });
}

Response post_simulate(const Request& request, const std::string&, Service& service) {
  ViewRequest asked;
  asked.scene = asked_simulation(request, service).scene;
  const Requester requester = requester_of(request);
  const RenderContext& context = service.rendering;
  const KnownScene scene = changed_scene_of(asked, context, requester);
  if (!scene->physics)
    throw InputError({FaultKind::missing, "/scene/physics", std::nullopt,
                      "a scene with physics, which says what its bodies are"});
  const auto simulation =
      context.pressed.simulation_of(scene, context.limits.max_events, requester);
  const std::size_t bytes = scene.others + scene.objects.bytes + bytes_of(*simulation);
  std::string text = context.go_through(
      bytes, requester, [&] { return to_json(simulation_json(*scene, *simulation)); });
  return {.content_type = "application/json",
          .body = std::move(text),
          .headers = {{"Cache-Control", "no-cache"}}};
}

Value answer_schema(Definitions& named) {
  return simulation_schema(schema_for<Scene>(named), named);
}

std::vector<Content> simulate_body() {
  return {
      {media::json, schema_for<SimulateRequest>, {{"a ball that falls and bounces", R"({"scene": {
  "objects": [{"name": "ball", "type": "sphere", "center": [0, 2, -9], "radius": 0.5},
              {"name": "floor", "type": "plane", "point": [0, -1, 0], "normal": [0, 1, 0]}],
  "lights": [{"type": "point", "position": [4, 6, -3]}],
  "physics": {"duration": 3, "bodies": [{"object": "ball", "mass": 1, "restitution": 0.8}],
              "fixed": [{"object": "floor"}]}}})"}}}};
}

}  // namespace

std::vector<Route> simulate_routes() {
  return {{.method = "POST",
           .path = "/simulate",
           .name = "post_simulate",
           .about = "how a scene's bodies move: the scene with tracks in the place of its physics, "
                    "who met whom, and the energy",
           .rights = {Right::render},
           .pace = Pace::in_turn,
           .handler = post_simulate,
           .answers = {ok("the motion, which needs no solver any more", media::json, answer_schema,
                          {"Cache-Control"})},
           .gives = {media::json},
           .body = simulate_body()}};
}

}  // namespace tia::server
