// /radio/map: a scene with transmitters in; out comes what is received where, as a picture.
#include "server/contract/answers.h"
#include "server/contract/parameters.h"
#include "server/contract/query_parameters.h"
#include "server/handlers/bodies.h"
#include "server/handlers/handlers.h"
#include "server/handlers/picture_response.h"
#include "server/http/headers.h"
#include "server/operation/shared_flow.h"
#include "server/requests/accept.h"
#include "server/requests/etag.h"
#include "server/requests/map_request.h"
#include "server/requests/with_memory.h"

namespace tia::server {
namespace {

/// AskedMap: what is asked for, and whether Accept has chosen the format.
struct AskedMap {
  RadioMapRequest map;
  bool accepted = false;
};

AskedMap map_asked_in(Value parameters, const Request& request) {
  const bool accepted = choose_format(parameters, request, map_formats);
  return {read_described<RadioMapRequest>(parameters, {}, request.stop), accepted};
}

/// MapDrawing: one map that somebody waits for.
struct MapDrawing {
  const RadioMapRequest& asked;
  const KnownScene& scene;
  const std::string& recipe;
  const Requester& requester;
  Service& service;

  std::int64_t rays() const {
    const auto senders = static_cast<std::int64_t>(asked.senders().size());
    return asked.method == RadioMethod::image ? 0 : asked.rays * senders;
  }
  Picture operator()(SharedFlow& shared, const std::stop_token& stop) const {
    service.access.check_rays(requester.key, static_cast<double>(rays()));
    Stopwatch watch;
    auto ticket = service.admission.enter({}, requester.client, stop, &shared.place);
    Flow flow{Requester{ticket.client(), stop}.number()};
    const double queue_ms = watch.lap_ms();
    flow.became_long = [&] { ticket.turn_heavy(); };
    const SharedFlow::Going going(shared, flow);
    const RenderContext& context = service.rendering;
    const Workers workers = context.pool.workers(context.pool.threads(), stop, &flow);
    const auto attempt = [&] { return draw_map(asked, *scene, recipe, context.limits, workers); };
    Picture picture = with_memory_for(attempt, stop);
    picture.timing.queue = queue_ms;
    service.metrics.count(picture.rays, picture.timing);
    service.access.charge(requester.key, picture.rays.all());
    return picture;
  }
};

// Drawn once for all who ask for it at the same time.
PictureStore::Found map_of(const MapDrawing& drawing, const std::string& etag) {
  Service& service = drawing.service;
  const auto shared = std::make_shared<SharedFlow>(service.rendering.pool);
  PictureStore::Wish wish = waiting_wish(drawing.requester, nullptr, service);
  wish.draw = [&](const std::stop_token& given_up) { return drawing(*shared, given_up); };
  wish.joined_by = [shared](const std::string& client) { shared->also_for(client); };
  return service.pictures.get(etag, wish);
}

Response mapped(const AskedMap& asked, Stopwatch watch, const Request& request, Service& service) {
  const Requester requester = requester_of(request);
  const RenderContext& context = service.rendering;
  ViewRequest view;
  view.scene = asked.map.scene;
  const KnownScene scene = scene_of(view, context, requester);
  const std::string recipe =
      context.go_through(std::min(scene.objects.bytes, most_told_bytes), requester,
                         [&] { return recipe_of(asked.map, scene); });
  const std::string etag = etag_of(recipe);
  Headers headers{
      {"ETag", etag},
      {"Cache-Control", asked.map.wanted ? "public, max-age=31536000, immutable" : "no-cache"}};
  if (asked.accepted) add_vary(headers, "Accept");
  const std::string type(map_formats[static_cast<std::size_t>(asked.map.format)].media_type);
  if (request.method != "POST" && has_already(request, etag)) {
    headers.emplace_back("Cache-Status", "Tia; hit; detail=not-modified");
    return {.status = 304, .content_type = "", .body = "", .headers = headers};
  }
  if (request.is_head())
    return {.content_type = type, .body = "", .headers = headers, .unsized = true};
  const double parse_ms = watch.lap_ms();
  const auto found = map_of({asked.map, scene, recipe, requester, service}, etag);
  Response response = picture_response(found, parse_ms, watch.lap_ms());
  response.headers.insert(response.headers.end(), headers.begin(), headers.end());
  return response;
}

Response get_map(const Request& request, const std::string&, Service& service) {
  const Stopwatch watch;
  const auto read = [&] {
    return map_asked_in(query_object<RadioMapRequest>(request.query()), request);
  };
  return mapped(read_query(request, service, read), watch, request, service);
}

Response post_map(const Request& request, const std::string&, Service& service) {
  const Stopwatch watch;
  refuse_query(request);
  const auto read = [&] {
    const char* const what = "the parameters as a JSON object, with scene, tx, frequency_hz";
    return map_asked_in(body_json(request, what, service.config.json_limits()), request);
  };
  return mapped(read_body(request, service, read), watch, request, service);
}

Value map_schema(Definitions&) { return radio_map_schema(); }

Answer map_answer() {
  Answer answer{.about = "the map"};
  for (const MapFormatRow& row : map_formats)
    answer.contents.push_back(
        {row.media_type, row.format == MapFormat::json ? map_schema : nullptr});
  answer.headers = {"Server-Timing", "Tia-Rays", "Cache-Control", "ETag", "Cache-Status"};
  return answer;
}

}  // namespace

std::vector<Route> map_routes() {
  return {{.method = "GET",
           .path = "/radio/map",
           .name = "get_radio_map",
           .about = "what radio waves come to in each cell of a plan among a scene's bodies",
           .rights = {Right::render},
           .pace = Pace::in_turn,
           .handler = get_map,
           .answers = {map_answer(),
                       {304,
                        "If-None-Match names the map's tag: no ray was traced",
                        {},
                        {"ETag", "Cache-Control", "Cache-Status"}}},
           .chooses = true,
           .query = query_parameters<RadioMapRequest>,
           .examples = {"/radio/map?scene=flat&tx=2.6,1.6,2.4&frequency_hz=5e9&cell=1&rays=1000"}},
          {.method = "POST",
           .path = "/radio/map",
           .name = "post_radio_map",
           .about = "the same, parameters as a JSON object",
           .rights = {Right::render},
           .pace = Pace::in_turn,
           .handler = post_map,
           .answers = {map_answer()},
           .chooses = true,
           .body = {{media::json, schema_for<RadioMapRequest>, {{"beside a house", R"({
  "scene": {"objects": [{"name": "house", "type": "box", "min": [-4, 0, -3], "max": [4, 6, 3]}]},
  "tx": [[-9, 4, 0]], "frequency_hz": 2.4e9, "area": [-12, -8, 12, 8], "cell": 0.5})"}}}}}};
}

}  // namespace tia::server
