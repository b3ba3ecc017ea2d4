#include "core/scene/read_scene.h"

namespace tia {

Scene read_scene(std::string_view json) { return read_described<Scene>(parse_json(json)); }

std::string canonical_text(const Scene& scene) { return to_json(write_value(scene)); }

std::string scene_schema() {
  Definitions named;
  // Its fields stand in the document itself, where people look for them.
  const Value scene = Codec<Scene>::schema({}, named);
  Value::Object members = with_definitions(scene, named);
  members.emplace_back("$schema", "https://json-schema.org/draft/2020-12/schema");
  members.emplace_back("title", "Tia scene");
  return to_json(members);
}

}  // namespace tia
