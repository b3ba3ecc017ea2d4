// /scenes: the gallery and the scenes that are kept. /schema/scene.json: what a scene may be.
#include "core/input/nearest_listed.h"
#include "core/input/object_schema.h"
#include "core/motion/simulate.h"
#include "core/scene/animation_check.h"
#include "core/scene/keys.h"
#include "core/scene/read_scene.h"
#include "server/contract/answers.h"
#include "server/contract/parameters.h"
#include "server/contract/problem.h"
#include "server/contract/query_parameters.h"
#include "server/handlers/bodies.h"
#include "server/handlers/handlers.h"
#include "server/operation/memory_costs.h"
#include "server/stores/digest.h"
#include "server/stores/random_key.h"
#include "server/stores/scene_bytes.h"

namespace tia::server {
namespace {

constexpr const char* delete_key = "Tia-Delete-Key";

Response scene_text(std::string text) {
  return {.content_type = "application/json", .body = std::move(text)};
}

Response get_scenes(const Request&, const std::string&, Service& service) {
  return {.content_type = "application/json", .body = service.rendering.gallery.listing()};
}

// The plain scene of that moment, which /render draws.
Response scene_at(const Moment& moment, const std::string& name, const Requester& requester,
                  Service& service) {
  ViewRequest asked;
  asked.scene = name;
  static_cast<Moment&>(asked) = moment;
  const KnownScene scene = scene_of(asked, service.rendering, requester);
  return service.rendering.go_through(scene.others + scene.objects.bytes, requester,
                                      [&] { return scene_text(canonical_text(*scene)); });
}

Response get_scene(const Request& request, const std::string& name, Service& service) {
  const Gallery& gallery = service.rendering.gallery;
  const auto moment = read_described<Moment>(query_object<Moment>(request.query()));
  const bool is_known =
      gallery.has(name) || service.rendering.kept.find(name, requester_of(request));
  if (moment.is_asked() && is_known) return scene_at(moment, name, requester_of(request), service);
  if (gallery.has(name)) return scene_text(gallery.text(name));
  const Requester requester = requester_of(request);
  if (const KnownScene kept = service.rendering.kept.find(name, requester)) {
    const std::size_t bytes = bytes_of(*kept);
    const std::int64_t memory = memory_for(memory_cost::patch, bytes);
    return service.rendering.long_work({bytes, memory, "the scene's text"}, requester,
                                       [&] { return scene_text(canonical_text(*kept)); });
  }
  throw HttpError("not-found",
                  "no scene is called that; there are: " + nearest_listed(name, gallery.names()) +
                      " in GET /scenes, and those lately sent to POST /scenes, by their ids");
}

Response post_scene(const Request& request, const std::string&, Service& service) {
  const NewScene made = read_body(request, service, [&] {
    const char* const what = "the scene as a JSON object, such as {\"objects\":[]}";
    Scene read = read_described<Scene>(body_json(request, what, service.config.json_limits()), {},
                                       request.stop);  // the JSON tree ends here
    check_keys(read, request.stop);
    check_animation(read, request.stop);
    check_physics(read, {}, request.stop);
    return NewScene(std::move(read));
  });
  const std::string key = random_key(), key_hash = sha256_hex(key);
  SceneStore& kept = service.rendering.kept;
  const std::string id = kept.keep(made, {share_of(request.peer), key_hash, 0});
  const std::string location = "/scenes/" + id;
  Response response{.status = 201,
                    .content_type = "application/json",
                    .body = to_json(Value::Object{{"id", id}, {"location", location}}),
                    .headers = {{"Location", location}, {"Cache-Control", "no-store"}}};
  if (kept.knows_owner(id, key_hash)) response.headers.emplace_back(delete_key, key);
  return response;
}

// The gallery's names are no ids, and stay.
Response delete_scene(const Request& request, const std::string& id, Service& service) {
  refuse_query(request);
  switch (service.rendering.kept.remove(id, sha256_hex(request.header(delete_key)))) {
    case Removal::done: return {.status = 204, .content_type = "", .body = ""};
    case Removal::forbidden:
      throw HttpError("forbidden",
                      "send the Tia-Delete-Key that POST /scenes has answered for this scene");
    case Removal::unknown: break;
  }
  throw HttpError("not-found", "no kept scene has that id");
}

Value kept_scene_schema(Definitions& named) {
  return schema_called("kept_scene", named, [] {
    const Value text = plain_schema<std::string>();
    return object_schema({{"id", text, "its name from now on: SHA-256 of its canonical text"},
                          {"location", text, "where it is"}});
  });
}

Response get_scene_schema(const Request&, const std::string&, Service&) {
  static const std::string text = scene_schema();  // made once: it takes milliseconds
  return {.content_type = "application/schema+json", .body = text};
}

// Only that it is a schema: the schema of schemas is elsewhere (JSON Schema 2020-12).
Value any_schema(Definitions&) {
  return Value::Object{{"type", "object"}, {"required", Value::Array{"$schema"}}};
}

std::vector<Content> scene_body() {
  return {
      {media::json,
       schema_for<Scene>,
       {{"one ball", R"({"objects": [{"type": "sphere", "center": [0, 0, -9], "radius": 2}]})"}}}};
}

}  // namespace

std::vector<Route> scene_routes() {
  return {{.method = "GET",
           .path = "/scenes",
           .name = "get_scenes",
           .about = "the gallery: names and titles",
           .rights = {Right::scenes},
           .handler = get_scenes,
           .answers = {ok("the scenes that come with the server", media::json,
                          Gallery::listing_schema)},
           .gives = {media::json}},
          {.method = "POST",
           .path = "/scenes",
           .name = "post_scene",
           .about = "keeps a scene: its id is a name",
           .rights = {Right::scenes},
           .pace = Pace::in_turn,
           .handler = post_scene,
           .answers = {{201,
                        "the scene is kept",
                        {{media::json, kept_scene_schema}},
                        {"Location", "Cache-Control", "Tia-Delete-Key"}}},
           .gives = {media::json},
           .body = scene_body()},
          {.method = "GET",
           .path = "/scenes/{}",
           .name = "get_scene",
           .about = "one scene's canonical JSON; with time or frame the plain scene of that moment",
           .rights = {Right::scenes},
           .pace = Pace::in_turn,
           .handler = get_scene,
           .answers = {ok("the scene, fields at their defaults left out (RFC 8785)", media::json,
                          schema_for<Scene>)},
           .gives = {media::json},
           .query = query_parameters<Moment>,
           .segment = {"name", "a name of the gallery, or the id of a kept scene"},
           .examples = {"/scenes/thesis"}},
          {.method = "DELETE",
           .path = "/scenes/{}",
           .name = "delete_scene",
           .about = "forgets a kept scene, once all who have kept it want that; with the header "
                    "Tia-Delete-Key that POST /scenes has answered",
           .rights = {Right::scenes},
           .pace = Pace::in_turn,
           .handler = delete_scene,
           .answers = {{204, "it is forgotten, as far as this client has kept it"}},
           .segment = {"name", "the id of a kept scene"}},
          {.method = "GET",
           .path = "/schema/scene.json",
           .name = "get_scene_schema",
           .about = "JSON Schema of a scene",
           .handler = get_scene_schema,
           .answers = {ok("JSON Schema 2020-12", media::json_schema, any_schema)},
           .gives = {media::json_schema, media::json}}};
}

}  // namespace tia::server
