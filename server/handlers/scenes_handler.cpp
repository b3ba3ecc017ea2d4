// /scenes: the gallery and the scenes that are kept. /schema/scene.json: what a scene may be.
#include <sys/random.h>

#include <array>

#include "core/input/object_schema.h"
#include "core/scene/keys.h"
#include "core/scene/read_scene.h"
#include "server/contract/parameters.h"
#include "server/contract/problem.h"
#include "server/handlers/bodies.h"
#include "server/handlers/handlers.h"
#include "server/operation/memory_costs.h"
#include "server/stores/digest.h"
#include "server/stores/scene_bytes.h"

namespace tia::server {
namespace {

constexpr const char* delete_key = "Tia-Delete-Key";

// 128 bits of the system's randomness, in hexadecimal digits.
std::string random_key() {
  std::array<unsigned char, 16> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    throw StorageError("the system has no random bytes");
  std::string key;
  for (const unsigned char byte : bytes) {
    key += "0123456789abcdef"[byte >> 4U];
    key += "0123456789abcdef"[byte & 15U];
  }
  return key;
}

Response scene_text(const Scene& scene) {
  return {.content_type = "application/json", .body = canonical_text(scene)};
}

}  // namespace

Response get_scenes(const Request&, const std::string&, Service& service) {
  return {.content_type = "application/json", .body = service.studio.gallery.listing()};
}

Response get_scene(const Request& request, const std::string& name, Service& service) {
  const Gallery& gallery = service.studio.gallery;
  if (const KnownScene scene = gallery.find(name)) return scene_text(*scene);
  const Asker asker = asker_of(request);
  if (const KnownScene kept = service.studio.kept.find(name, asker)) {
    const std::size_t bytes = bytes_of(*kept);
    const std::int64_t memory = memory_for(memory_cost::patch, bytes);
    return service.studio.long_work({bytes, memory, "the scene's text"}, asker,
                                    [&] { return scene_text(*kept); });
  }
  throw HttpError("not-found", "no scene is called that; there are: " + listed(gallery.names()) +
                                   ", and those lately sent to POST /scenes, by their ids");
}

Response post_scene(const Request& request, const std::string&, Service& service) {
  const NewScene made = read_body(request, service, [&] {
    const char* const what = "the scene as a JSON object, such as {\"objects\":[]}";
    Scene read = read_described<Scene>(body_json(request, what, service.config.json_limits()), {},
                                       request.stop);  // the JSON tree ends here
    check_keys(read, request.stop);
    return NewScene(std::move(read));
  });
  const std::string key = random_key(), key_hash = sha256_hex(key);
  SceneStore& kept = service.studio.kept;
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
  switch (service.studio.kept.remove(id, sha256_hex(request.header(delete_key)))) {
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

}  // namespace tia::server
