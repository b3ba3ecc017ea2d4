// /scenes: the gallery and the scenes that are kept. /schema/scene.json: what a scene may be.
#include "core/input/written.h"
#include "core/scene/keys.h"
#include "core/scene/read_scene.h"
#include "server/handlers.h"
#include "server/parameters.h"
#include "server/problem.h"

namespace tia::server {
namespace {

Response scene_text(const Scene& scene) {
  return {.content_type = "application/json", .body = canonical_text(scene)};
}

}  // namespace

Response get_scenes(const Request&, const std::string&, Service& service) {
  return {.content_type = "application/json", .body = service.studio.gallery.listing()};
}

Response get_scene(const Request&, const std::string& name, Service& service) {
  const Gallery& gallery = service.studio.gallery;
  if (const KnownScene scene = gallery.find(name)) return scene_text(*scene);
  if (const KnownScene kept = service.studio.kept.find(name)) return scene_text(*kept);
  throw HttpError("not-found", "no scene is called that; there are: " + listed(gallery.names()) +
                                   ", and those lately sent to POST /scenes, by their ids");
}

Response post_scene(const Request& request, const std::string&, Service& service) {
  const auto ticket = service.admission.read(request.body.size(), request.stop);
  const char* const what = "the scene as a JSON object, such as {\"objects\":[]}";
  Scene scene = read_described<Scene>(body_json(request, what, service.config.json_limits()), {},
                                      request.stop);  // the JSON tree ends here
  check_keys(scene, request.stop);
  const std::string id = service.studio.kept.keep(std::move(scene));
  const std::string location = "/scenes/" + id;
  return {.status = 201,
          .content_type = "application/json",
          .body = to_json(Value::Object{{"id", id}, {"location", location}}),
          .headers = {{"Location", location}}};
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

}  // namespace tia::server
