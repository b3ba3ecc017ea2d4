#include "core/scene/keys.h"

#include <algorithm>

#include "core/scene/read_scene.h"
#include "core/scene/view.h"

namespace tia {
namespace {

struct DefaultKey {
  std::string_view key;
  Vec3d towards;  // right, up, towards the viewer; the thesis' four places seen from its ball
};
constexpr DefaultKey default_keys[] = {
    {"a", {-2, 2, 1}}, {"d", {2, 2, 1}}, {"s", {0, 4, 3}}, {"w", {0, 5, -3}}};

// look_at, else the point of the view axis that lies as deep as the objects with bounds do on
// average.
Vec3d looked_at(const Scene& scene, const Vec3d& axis) {
  if (scene.camera.look_at) return *scene.camera.look_at;
  double depth = 0, count = 0;
  for (const Object& object : scene.objects) {
    const Aabb box = bounds_of(object);
    if (box.empty() || !box.bounded()) continue;
    depth += dot(box.center() - scene.camera.location, axis);
    count += 1;
  }
  return scene.camera.location + axis * (depth > 0 ? depth / count : 1);
}

// The key light: the scene's own, else its first light that can be moved.
template <class AnyScene>
auto* key_light_of(AnyScene& scene) {
  if (scene.key_light) return &*scene.key_light;
  const auto found = std::ranges::find_if(scene.lights, &Light::movable);
  return found == scene.lights.end() ? nullptr : &*found;
}

Vec3d axis_of(const Scene& scene) { return normalize(view_of(scene.camera, 1, 1).forward); }

// As seen from the camera, around the point looked at, at the distance that the light had (the
// eye's, where it had none).
Vec3d default_place(const Scene& scene, const Vec3d& towards) {
  const View view = view_of(scene.camera, 1, 1);
  const Vec3d axis = normalize(view.forward);
  const Vec3d right = normalize(view.right);
  const Vec3d across = cross(right, axis);
  const Vec3d up = dot(across, view.up) < 0 ? -across : across;  // a view plane may mirror
  const Vec3d target = looked_at(scene, axis);
  const Light* light = key_light_of(scene);
  const auto place = light != nullptr ? light->place() : std::nullopt;
  const Vec3d from = place.value_or(scene.camera.location);
  const Vec3d way = normalize(right * towards.x + up * towards.y - axis * towards.z);
  return target + way * length(from - target);
}

[[noreturn]] void unknown_key(const Scene& scene, std::string_view key, std::string_view pointer) {
  const auto known = keys_of(scene);
  throw InputError({FaultKind::unknown_name, std::string(pointer), Value(key),
                    "one of " + listed(known), nearest_name(key, known)});
}

}  // namespace

std::vector<std::string_view> keys_of(const Scene& scene) {
  std::vector<std::string_view> names;
  for (const auto& [name, binding] : scene.keys) names.push_back(name);
  if (names.empty())
    for (const auto& [key, towards] : default_keys) names.push_back(key);
  return names;
}

bool moves_light_only(const Scene& scene, std::string_view key) {
  const auto binding = scene.keys.find(std::string(key));
  return binding == scene.keys.end() || std::holds_alternative<Vec3d>(binding->second);
}

Scene press(const Scene& scene, std::string_view key, std::string_view pointer) {
  if (scene.keys.empty()) {
    for (const DefaultKey& each : default_keys)
      if (each.key == key) return with_light(scene, default_place(scene, each.towards), pointer);
    unknown_key(scene, key, pointer);
  }
  const auto binding = scene.keys.find(std::string(key));
  if (binding == scene.keys.end()) unknown_key(scene, key, pointer);
  if (const auto* position = std::get_if<Vec3d>(&binding->second))
    return with_light(scene, *position, pointer);
  const Value patched = merge_patch(write_value(scene), std::get<Value>(binding->second));
  try {
    return read_described<Scene>(patched);
  } catch (const InputError& error) {
    const std::size_t more = error.faults().size() - 1;
    throw InputError({FaultKind::conflict, std::string(pointer), Value(key),
                      "a key whose patch leaves a scene; after this one " +
                          describe(error.faults().front()) +
                          (more > 0 ? "; and " + std::to_string(more) + " faults more" : "")});
  }
}

Scene with_light(Scene scene, const Vec3d& position, std::string_view pointer) {
  const Vec3d target = looked_at(scene, axis_of(scene));
  Light* light = key_light_of(scene);
  if (light == nullptr) light = &scene.lights.emplace_back();
  light->move_to(position, target);
  Faults faults;
  light->check_kind(faults);
  if (!faults.empty())
    throw InputError({FaultKind::out_of_range, std::string(pointer), write_value(position),
                      "a place that this light can shine from; there it has " +
                          describe(faults.list().front())});
  return scene;
}

}  // namespace tia
