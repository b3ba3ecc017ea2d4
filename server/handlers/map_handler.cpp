// /radio/map: a scene with transmitters in; out comes what is received where, as a picture.
#include <array>

#include "server/contract/answers.h"
#include "server/contract/parameters.h"
#include "server/contract/query_parameters.h"
#include "server/handlers/bodies.h"
#include "server/handlers/handlers.h"
#include "server/handlers/picture_response.h"
#include "server/handlers/rendered.h"
#include "server/handlers/stream_response.h"
#include "server/http/headers.h"
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

/// KnownMap: one that is asked for, and what it is called. Its scene may be that of the request.
struct KnownMap {
  AskedMap asked;
  ViewRequest view;
  KnownScene scene;
  std::string recipe, etag;

  KnownMap(AskedMap of, const Requester& requester, const Service& service) : asked(std::move(of)) {
    const RenderContext& context = service.rendering;
    view.scene = std::move(asked.map.scene);
    scene = scene_of(view, context, requester);
    recipe = context.go_through(std::min(scene.objects.bytes, most_told_bytes), requester,
                                [&] { return recipe_of(asked.map, scene); });
    etag = etag_of(recipe);
  }
  KnownMap(const KnownMap&) = delete;
  KnownMap& operator=(const KnownMap&) = delete;
};

/// MapDrawing: one map that somebody waits for.
struct MapDrawing {
  const KnownMap& known;
  const Requester& requester;
  Service& service;
  Showing& showing;

  // How many times larger cells are that are shown first: a twelfth of the map's own come to that.
  static constexpr std::array coarse{8, 4};

  std::int64_t rays() const {
    const DrawnMap& asked = known.asked.map;
    const auto senders = static_cast<std::int64_t>(asked.senders().size());
    return asked.method == RadioMethod::image ? 0 : asked.rays * senders;
  }
  Picture operator()(SharedFlow& shared, const std::stop_token& stop) const {
    const std::size_t maps = showing.is_watched() ? 1 + coarse.size() : 1;
    service.access.check_rays(requester.key,
                              static_cast<double>(rays()) * static_cast<double>(maps));
    Stopwatch watch;
    auto ticket = service.admission.enter({}, requester.client, stop, &shared.place);
    Flow flow{Requester{ticket.client(), stop}.number()};
    const double queue_ms = watch.lap_ms();
    flow.became_long = [&] { ticket.turn_heavy(); };
    const SharedFlow::Going going(shared, flow);
    Pool& pool = service.rendering.pool;
    const Workers workers = pool.workers(pool.threads(), stop, &flow);
    if (showing.is_watched()) show_coarse(workers, stop);
    Picture picture = drawn(known.asked.map, known.recipe, workers, stop);
    picture.timing.queue = queue_ms;
    return picture;
  }

 private:
  Picture drawn(const DrawnMap& map, const std::string& recipe, const Workers& workers,
                const std::stop_token& stop) const {
    const auto attempt = [&] {
      return draw_map(map, *known.scene, recipe, service.rendering.limits, workers);
    };
    Picture picture = with_memory_for(attempt, stop);
    service.metrics.count(picture.rays, picture.timing);
    service.access.charge(requester.key, picture.rays.all());
    return picture;
  }
  void show_coarse(const Workers& workers, const std::stop_token& stop) const {
    int round = 0;
    for (const int times : coarse) {
      const DrawnMap map = coarser(known.asked.map, *known.scene, times, service.rendering.limits);
      const std::string recipe = recipe_of(map, known.scene);
      Picture picture = drawn(map, recipe, workers, stop);
      picture.etag = etag_of(recipe);
      const auto shown = std::make_shared<const Picture>(std::move(picture));
      service.pictures.add(shown->etag, shown);
      service.metrics.count_shown();
      showing.show({shown, round++, true});
    }
  }
};

PictureStore::Found map_of(const KnownMap& known, const Requester& requester, Service& service,
                           const Showing::See& see = nullptr) {
  return drawn_once(known.etag, requester, service, see,
                    [&](SharedFlow& flow, Showing& showing, const std::stop_token& stop) {
                      return MapDrawing{known, requester, service, showing}(flow, stop);
                    });
}

Response shown_map(const std::shared_ptr<const KnownMap>& known, const Request& request,
                   Service& service) {
  const auto drawing = [known, requester = requester_of(request), &service](const auto& see) {
    return map_of(*known, requester, service, see);
  };
  return streamed(*known->asked.map.stream, known->etag, drawing, request, service);
}

void check_streamed_map(const RadioMapRequest& asked, const Request& request) {
  if (!asked.stream) return;
  check_stream(name_of(*asked.stream), request,
               asked.format == MapFormat::png ? Format::png : Format::pfm);
}

Response mapped(AskedMap asked, Stopwatch watch, const Request& request, Service& service) {
  check_streamed_map(asked.map, request);
  const Requester requester = requester_of(request);
  const auto known = std::make_shared<const KnownMap>(std::move(asked), requester, service);
  const RadioMapRequest& map = known->asked.map;
  if (map.stream) return shown_map(known, request, service);
  Headers headers{
      {"ETag", known->etag},
      {"Cache-Control", map.wanted ? "public, max-age=31536000, immutable" : "no-cache"}};
  if (known->asked.accepted) add_vary(headers, "Accept");
  const std::string type(map_formats[static_cast<std::size_t>(map.format)].media_type);
  if (request.method != "POST" && has_already(request, known->etag)) {
    headers.emplace_back("Cache-Status", "Tia; hit; detail=not-modified");
    return {.status = 304, .content_type = "", .body = "", .headers = headers};
  }
  if (request.is_head())
    return {.content_type = type, .body = "", .headers = headers, .unsized = true};
  const double parse_ms = watch.lap_ms();
  const auto found = map_of(*known, requester, service);
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
  return shown_answer(std::move(answer));
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
