// /scenes: the gallery. /schema/scene.json: what a scene may be.
#include "core/input/json.h"
#include "core/scene/read_scene.h"
#include "server/handlers.h"
#include "server/problem.h"

namespace tia::server {

Response get_scenes(const Request&, const std::string&, Service& service) {
  Value::Array list;
  for (const auto& [name, scene] : service.studio.gallery.scenes())
    list.push_back(
        Value::Object{{"name", name}, {"title", scene.title}, {"description", scene.description}});
  return {.content_type = "application/json", .body = to_json(Value::Object{{"scenes", list}})};
}

Response get_scene(const Request&, const std::string& name, Service& service) {
  const Gallery& gallery = service.studio.gallery;
  if (const Scene* scene = gallery.find(name))
    return {.content_type = "application/json", .body = canonical_text(*scene)};
  std::vector<std::string_view> known;
  for (const auto& [each, scene] : gallery.scenes()) known.push_back(each);
  throw HttpError("not-found", "no scene is called that; there are: " + listed(known));
}

Response get_scene_schema(const Request&, const std::string&, Service&) {
  return {.content_type = "application/schema+json", .body = scene_schema()};
}

}  // namespace tia::server
