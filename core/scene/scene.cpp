#include "core/scene/scene.h"

namespace tia {
namespace {

constexpr Spec position{.about = "where the key puts the light", .min = -1e9, .max = 1e9};

// The binding's position where it has the one key `light` and nothing else.
const Value* only_light(const Value::Object& binding) {
  return binding.size() == 1 ? find(binding, "light") : nullptr;
}

}  // namespace

void Codec<KeyBinding>::read(const Value& v, const Place& at, const Spec&, Faults& faults,
                             KeyBinding& out) {
  const auto* binding = v.as<Value::Object>();
  if (binding == nullptr)
    return detail::wrong_type(v, at, R"({"light": [x, y, z]} or a JSON merge patch)", faults);
  if (const Value* light = only_light(*binding))
    read_value(*light, at.at("light"), position, faults, out.emplace<Vec3d>());
  else out = v;
}

Value Codec<KeyBinding>::write(const KeyBinding& v) {
  if (const auto* patch = std::get_if<Value>(&v)) return *patch;
  return Value::Object{{"light", write_value(std::get<Vec3d>(v))}};
}

Value Codec<KeyBinding>::schema(const Spec&, Definitions& named) {
  const Value::Array only{"light"};
  const Value light =
      Value::Object{{"type", "object"},
                    {"properties", Value::Object{{"light", schema_of<Vec3d>(position, named)}}},
                    {"required", only},
                    {"additionalProperties", false}};
  const Value alone = Value::Object{{"required", only}, {"maxProperties", 1}};
  const Value patch = Value::Object{{"type", "object"}, {"not", alone}};
  return Value::Object{{"oneOf", Value::Array{light, patch}}};
}

void Scene::check_links(const Place& at, Faults& faults) const {
  check_material_names(at, faults);
  const Place all_lights = at.at("lights");
  for (std::size_t i = 0; i < lights.size() && !faults.full(); ++i) {
    const Place light = all_lights.at(i);
    if (lights[i].position() || faults.within(light.pointer())) continue;
    faults.add(
        {FaultKind::missing, light.at("position").pointer(), std::nullopt, "where the light is"});
  }
}

void Scene::check_material_names(const Place& at, Faults& faults) const {
  if (faults.at(at.at("materials").pointer())) return;
  std::vector<std::string_view> known;
  for (const auto& [name, material] : materials) known.push_back(name);

  const Place all_objects = at.at("objects");
  for (std::size_t i = 0; i < objects.size() && !faults.full(); ++i) {
    const auto& material = objects[i].material;
    const auto* name = material ? std::get_if<std::string>(&*material) : nullptr;
    if (name == nullptr || materials.contains(*name)) continue;
    const Place object = all_objects.at(i);
    faults.add({FaultKind::unknown_name, object.at("material").pointer(), Value(*name),
                known.empty() ? "a material; the scene names none" : "one of " + listed(known),
                nearest_name(*name, known)});
  }
}

}  // namespace tia
