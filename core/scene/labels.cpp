#include "core/scene/labels.h"

#include <functional>

namespace tia {
namespace {

/// What a visit is told of each thing that a ray can meet: its name, if it has one, and its type.
using Visit = std::function<void(const std::string& name, std::string_view type, const Place&)>;

/// Around: what objects are part of that is lowered to them. They are not in the JSON: their place
/// is its own; and the name of walls is that of each piece.
struct Around {
  bool is_lowered = false;
  const std::string* name = nullptr;
};

void visit_objects(const std::vector<Object>& list, const Place& at, const Around& around,
                   const Visit& visit) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Object& object = list[i];
    const Place element = at.at(i);
    const Place& here = around.is_lowered ? at : element;
    if (is_many(object)) {
      const Place children = here.at("children");
      Around inside = around;
      if (is_lowered(object)) inside.is_lowered = true;
      if (std::holds_alternative<Walls>(object.shape)) inside.name = &object.name;
      visit_objects(*children_of(object), inside.is_lowered ? here : children, inside, visit);
      continue;
    }
    const auto type = [](const auto& shape) { return std::string_view(shape.type); };
    visit(around.name != nullptr ? *around.name : object.name, std::visit(type, object.shape),
          here);
  }
}

// Those that are seen are things that a ray can meet.
void visit_light(const Light& light, const Place& at, const Visit& visit) {
  if (light.awaited() == nullptr && light.seen()) visit("", light.type(), at);
}

// Of all of them, in the order of their numbers.
void visit_all(const Scene& scene, const Visit& visit) {
  const Place all{}, lights = all.at("lights");
  visit_objects(scene.objects, all.at("objects"), {}, visit);
  for (std::size_t i = 0; i < scene.lights.size(); ++i)
    visit_light(scene.lights[i], lights.at(i), visit);
  if (scene.key_light) visit_light(*scene.key_light, all.at("key_light"), visit);
}

}  // namespace

std::vector<ObjectLabel> object_labels(const Scene& scene) {
  std::vector<ObjectLabel> labels;
  visit_all(scene, [&](const std::string& name, std::string_view type, const Place& at) {
    labels.push_back({name.empty() ? at.pointer() : name, type});
  });
  return labels;
}

std::map<int, std::string> object_pointers(const Scene& scene, const std::set<int>& numbers) {
  std::map<int, std::string> pointers;
  int number = 0;
  visit_all(scene, [&](const std::string&, std::string_view, const Place& at) {
    if (numbers.contains(number)) pointers[number] = at.pointer();
    ++number;
  });
  return pointers;
}

}  // namespace tia
