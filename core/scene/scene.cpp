#include "core/scene/scene.h"

namespace tia {
namespace {

constexpr Spec position{.about = "where the key puts the light", .min = -1e9, .max = 1e9};

// The binding's position where it has the one key `light` and nothing else.
const Value* only_light(const Value::Object& binding) {
  return binding.size() == 1 ? find(binding, "light") : nullptr;
}

/// What objects inherit: the product of the transforms and copies above them, a material that
/// emits.
struct Inherited {
  Affine place{};
  std::int64_t copies = 1;
  bool luminous = false;
  bool operand = false;  ///< of a csg, perhaps by way of groups
};

/// Checks what objects are in objects: solids in solids, copies of what has bounds; and what they
/// multiply to: transforms, copies, and each copy of a luminous ball is a light.
class TreeCheck {
 public:
  TreeCheck(const Scene& scene, Faults& faults) : scene_(scene), faults_(faults) {}

  void operator()(const std::vector<Object>& list, const Inherited& above, const Place& at) {
    for (std::size_t i = 0; i < list.size() && !faults_.full(); ++i) {
      const Object& object = list[i];
      const Affine place = above.place * object.transform.affine();
      check(object, {place, above.copies, emits(object, above.luminous), above.operand}, at.at(i));
    }
  }

 private:
  static constexpr std::int64_t most_lights = 4096;
  static constexpr std::size_t most_numbered = 1 << 16;

  bool emits(const Object& object, bool inherited) const {
    if (!object.material) return inherited;
    const auto* boxed = std::get_if<Boxed<Material>>(&*object.material);
    const Material* own = boxed != nullptr ? &**boxed : nullptr;
    if (const auto* name = std::get_if<std::string>(&*object.material)) {
      const auto found = scene_.materials.find(*name);
      if (found == scene_.materials.end()) return false;
      own = &found->second;
    }
    return tia::emits(shading_of(*own, {}).emission.exact);
  }

  void check(const Object& object, const Inherited& own, const Place& at) {
    if (!is_usable(own.place) && is_usable(object.transform.affine()))
      faults_.add({FaultKind::out_of_range, at.at("transform").pointer(),
                   excerpt(write_value(object.transform)),
                   "with the transforms around it a scale of 1e-9 to 1e9 on every axis"});
    if (own.luminous && own.copies > 1 && lights_from_center(object.shape))
      count_lights(own.copies, at);
    if (own.operand) check_operand(object, at);
    count_materials(object, at);
    if (const auto* csg = std::get_if<Csg>(&object.shape)) {
      Inherited child = own;
      child.operand = true;
      (*this)(csg->children, child, at.at("children"));
    }
    if (const auto* group = std::get_if<Group>(&object.shape)) check_group(*group, own, at);
  }

  // An operand has an inside; a group is the union of its children.
  void check_operand(const Object& object, const Place& at) {
    if (const auto* group = std::get_if<Group>(&object.shape)) {
      if (group->repeat)
        faults_.add({FaultKind::conflict, at.at("repeat").pointer(), write_value(*group->repeat),
                     "a group without repeat, in a csg"});
      return;
    }
    if (is_solid(object.shape)) return;
    const std::string_view type =
        std::visit([]<class Kind>(const Kind&) { return Kind::type; }, object.shape);
    faults_.add({FaultKind::out_of_range, at.at("type").pointer(), Value(type),
                 "in a csg a solid (" + solid_names() + "or a group of them)"});
  }

  // Each is a part of its own to the tracer: a few bytes would cost hundreds.
  void count_materials(const Object& object, const Place& at) {
    const std::size_t own = numbered_materials(object).size();
    numbered_ += own;
    if (own > 0 && numbered_ > most_numbered)
      faults_.add({FaultKind::limit, at.at("materials").pointer(), std::nullopt,
                   "at most " + std::to_string(most_numbered) +
                       " numbered materials of all objects together"});
  }

  void count_lights(std::int64_t copies, const Place& at) {
    lights_ += copies;
    if (lights_ > most_lights)
      faults_.add({FaultKind::limit, at.pointer(), std::nullopt,
                   "at most " + std::to_string(most_lights) +
                       " luminous balls, copies counted: each is a light"});
  }

  void check_group(const Group& group, const Inherited& own, const Place& at) {
    const Place children = at.at("children");
    Inherited child = own;
    if (group.repeat) child.copies *= group.repeat->copies();
    if (child.copies > Repeat::most) {
      add_too_many_copies(group, own.copies, at);
      child.copies = own.copies;
    }
    if (group.repeat) check_bounds(group, at, children);
    (*this)(group.children, child, children);
  }

  void add_too_many_copies(const Group& group, std::int64_t above, const Place& at) {
    std::string allowed = "at most " + std::to_string(Repeat::most) + " copies in all";
    if (above > 1)
      allowed = "with the groups around it " + allowed + "; those make " + std::to_string(above);
    faults_.add({FaultKind::limit, at.at("repeat").at("count").pointer(),
                 write_value(group.repeat->count), allowed});
  }

  void check_bounds(const Group& group, const Place& at, const Place& children) {
    for (std::size_t i = 0; i < group.children.size() && !faults_.full(); ++i) {
      const Place child = children.at(i);
      if (faults_.within(child.pointer())) continue;  // what it is cannot be told
      const Aabb box = bounds_.of(group.children[i]);
      if (box.empty() || box.bounded()) continue;
      faults_.add({FaultKind::conflict, at.at("repeat").pointer(), write_value(*group.repeat),
                   "a group whose children have bounds; " + child.pointer() + " has none"});
    }
  }

  const Scene& scene_;
  Faults& faults_;
  ObjectBounds bounds_{faults_.stop()};
  std::int64_t lights_ = 0;
  std::size_t numbered_ = 0;
};

}  // namespace

void SceneOptions::check(const Place& at, Faults& faults) const {
  if (blur_steps && samples && *blur_steps > *samples)
    faults.add({FaultKind::conflict, at.at("blur_steps").pointer(), Value(*blur_steps),
                "at most the samples of a pixel, which are " + std::to_string(*samples)});
  if (noise.value_or(0) == 0) return;
  const auto refuse = [&](const std::string& allowed) {
    faults.add({FaultKind::conflict, at.at("noise").pointer(), write_value(*noise), allowed});
  };
  if (!row_of(integrator).is_chance())
    refuse("an integrator whose rays are chance (" + chance_names() + "), or no noise");
  else if (threshold.value_or(0) > 0) refuse("noise or threshold");
}

void Codec<KeyBinding>::read(const Value& v, const Place& at, const Spec&, Faults& faults,
                             KeyBinding& out) {
  const auto* binding = v.as<Value::Object>();
  if (binding == nullptr)
    return detail::wrong_type(v, at, R"({"light": [x, y, z]} or a JSON merge patch)", faults);
  if (const Value* light = only_light(*binding))
    read_value(*light, at.at("light"), position, faults, out.emplace<Vec3d>());
  else out = SharedValue(v);
}

Value Codec<KeyBinding>::write(const KeyBinding& v) {
  if (const auto* patch = std::get_if<SharedValue>(&v)) return **patch;
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

namespace {

// Each makes a sky of its own, which takes some 30 ms; as many, and a key light's, are kept.
constexpr std::size_t most_suns = 4;
void check_suns(const std::vector<Light>& lights, const Place& at, Faults& faults) {
  std::size_t suns = 0;
  for (std::size_t i = 0; i < lights.size() && !faults.full(); ++i) {
    if (!std::holds_alternative<SunLight>(lights[i].kind) || ++suns <= most_suns) continue;
    faults.add({FaultKind::limit, at.at(i).pointer(), std::nullopt,
                "at most " + std::to_string(most_suns) + " suns"});
  }
}

}  // namespace

void Scene::check_links(const Place& at, Faults& faults) const {
  const Place all_objects = at.at("objects");
  if (!faults.at(at.at("materials").pointer())) check_material_names(objects, all_objects, faults);
  TreeCheck(*this, faults)(objects, {}, all_objects);
  const Place all_lights = at.at("lights");
  for (std::size_t i = 0; i < lights.size() && !faults.full(); ++i) {
    const Place light = all_lights.at(i);
    if (lights[i].awaited() == nullptr || faults.within(light.pointer())) continue;
    faults.add({FaultKind::missing, light.at(lights[i].awaited()).pointer(), std::nullopt,
                "where the light is, or which way it travels"});
  }
  check_suns(lights, all_lights, faults);
  if (shadow_ground && !backdrop)
    faults.add({FaultKind::conflict, at.at("shadow_ground").pointer(), std::nullopt,
                "a scene that has a backdrop"});
}

void Scene::check_material_names(const std::vector<Object>& list, const Place& at,
                                 Faults& faults) const {
  for (std::size_t i = 0; i < list.size() && !faults.full(); ++i) {
    const Place object = at.at(i);
    if (const auto* children = children_of(list[i]))
      check_material_names(*children, object.at("children"), faults);
    if (list[i].material) check_material_name(*list[i].material, object.at("material"), faults);
    const Place several = object.at("materials");
    const std::vector<MaterialRef>& numbered = numbered_materials(list[i]);
    for (std::size_t k = 0; k < numbered.size() && !faults.full(); ++k)
      check_material_name(numbered[k], several.at(k), faults);
    for (const auto& [name, material] : named_materials(list[i]))
      if (!faults.full()) check_material_name(material, several.at(name), faults);
  }
}

void Scene::check_material_name(const MaterialRef& material, const Place& at,
                                Faults& faults) const {
  const auto* name = std::get_if<std::string>(&material);
  if (name == nullptr || materials.contains(*name)) return;
  std::vector<std::string_view> known;
  for (const auto& [each, its_material] : materials) known.push_back(each);
  faults.add({FaultKind::unknown_name, at.pointer(), Value(*name),
              known.empty() ? "a material; the scene names none" : "one of " + listed(known),
              nearest_name(*name, known)});
}

template struct FieldsCodec<Scene>;
bool Scene::operator==(const Scene&) const = default;

}  // namespace tia
