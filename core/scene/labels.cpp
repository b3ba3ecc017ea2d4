#include "core/scene/labels.h"

namespace tia {
namespace {

void add_objects(const std::vector<Object>& list, const Place& at,
                 std::vector<ObjectLabel>& labels) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Object& object = list[i];
    const Place here = at.at(i);
    if (const auto* group = std::get_if<Group>(&object.shape)) {
      add_objects(group->children, here.at("children"), labels);
      continue;
    }
    const auto type = [](const auto& shape) { return std::string_view(shape.type); };
    labels.push_back(
        {object.name.empty() ? here.pointer() : object.name, std::visit(type, object.shape)});
  }
}

// Luminous ones are things that a ray can meet.
void add_light(const Light& light, const Place& at, std::vector<ObjectLabel>& labels) {
  if (light.awaited() != nullptr) return;
  if (std::holds_alternative<SphereLight>(light.kind))
    labels.push_back({at.pointer(), SphereLight::type});
  if (std::holds_alternative<QuadLight>(light.kind))
    labels.push_back({at.pointer(), QuadLight::type});
}

}  // namespace

std::vector<ObjectLabel> object_labels(const Scene& scene) {
  std::vector<ObjectLabel> labels;
  const Place all{}, lights = all.at("lights");
  add_objects(scene.objects, all.at("objects"), labels);
  for (std::size_t i = 0; i < scene.lights.size(); ++i)
    add_light(scene.lights[i], lights.at(i), labels);
  if (scene.key_light) add_light(*scene.key_light, all.at("key_light"), labels);
  return labels;
}

}  // namespace tia
