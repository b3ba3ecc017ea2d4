#include "core/scene/keys.h"

#include <algorithm>
#include <optional>

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
Vec3d looked_at(const Scene& scene, const Vec3d& axis, const Middles& middles) {
  if (scene.camera.look_at) return *scene.camera.look_at;
  double depth = 0;
  for (const Vec3d& middle : middles) depth += dot(middle - scene.camera.location, axis);
  const auto count = static_cast<double>(middles.size());
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
Vec3d default_place(const Scene& scene, const Vec3d& towards, const Middles& middles) {
  const View view = view_of(scene.camera, 1, 1);
  const Vec3d axis = normalize(view.forward);
  const Vec3d right = normalize(view.right);
  const Vec3d across = cross(right, axis);
  const Vec3d up = dot(across, view.up) < 0 ? -across : across;  // a view plane may mirror
  const Vec3d target = looked_at(scene, axis, middles);
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

std::string others(std::size_t faults) {
  return faults > 1 ? "; and " + std::to_string(faults - 1) + " faults more" : "";
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

Middles middles_of(const Scene& scene, const std::stop_token& stop) {
  Middles middles;
  if (scene.camera.look_at) return middles;
  for (const Object& object : scene.objects) {
    const Aabb box = bounds_of(object, stop);
    if (!box.empty() && box.bounded()) middles.push_back(box.center());
  }
  return middles;
}

Scene press(const Scene& scene, std::string_view key, const Middles& middles,
            std::string_view pointer, const std::stop_token& stop) {
  if (scene.keys.empty()) {
    for (const DefaultKey& each : default_keys)
      if (each.key == key)
        return with_light(scene, default_place(scene, each.towards, middles), middles, pointer);
    unknown_key(scene, key, pointer);
  }
  const auto binding = scene.keys.find(std::string(key));
  if (binding == scene.keys.end()) unknown_key(scene, key, pointer);
  if (const auto* position = std::get_if<Vec3d>(&binding->second))
    return with_light(scene, *position, middles, pointer);
  const Value patched = merge_patch(write_value(scene), *std::get<SharedValue>(binding->second));
  try {
    return read_described<Scene>(patched, {}, stop);
  } catch (const InputError& error) {
    throw InputError({FaultKind::conflict, std::string(pointer), Value(key),
                      "a key whose patch leaves a scene; after this one " +
                          describe(error.faults().front()) + others(error.faults().size())});
  }
}

namespace {

// What is wrong with a light after it has been put to a place, or nothing.
std::optional<Fault> put(Light& light, const Vec3d& position, const Vec3d& target,
                         std::string_view pointer) {
  light.move_to(position, target);
  Faults faults;
  light.check_kind(faults);
  if (faults.empty()) return std::nullopt;
  return Fault{
      FaultKind::out_of_range, std::string(pointer), write_value(position),
      "a place that this light can shine from; there it has " + describe(faults.list().front())};
}

}  // namespace

Scene with_light(Scene scene, const Vec3d& position, const Middles& middles,
                 std::string_view pointer) {
  const Vec3d target = looked_at(scene, axis_of(scene), middles);
  Light* light = key_light_of(scene);
  if (light == nullptr) light = &scene.lights.emplace_back();
  if (auto fault = put(*light, position, target, pointer)) throw InputError(std::move(*fault));
  return scene;
}

// ---- all keys at once -----------------------------------------------------------------------

namespace {

/// Visitor: writes the parts of a scene that a patch merges with, and those that it leaves but that
/// refer to what it changes: objects wear materials.
struct MergedParts {
  const Scene& scene;
  const Value::Object& patch;
  Value::Object parts = {};

  template <class Member>
  void operator()(std::string_view name, Member Scene::*member, const Spec&) {
    if (is_needed(name)) parts.emplace_back(name, write_value(scene.*member));
  }

 private:
  bool is_needed(std::string_view name) const {
    if (const Value* change = find(patch, name)) return change->as<Value::Object>() != nullptr;
    if (name == "objects") return find(patch, "materials") != nullptr;
    return name == "materials" && find(patch, "objects") != nullptr;
  }
};

/// KeyCheck: tries one key after the other; what is found is in `faults`.
class KeyCheck {
 public:
  KeyCheck(const Scene& scene, const std::stop_token& stop) : scene_(scene), stop_(stop) {}

  void operator()() {
    const Place all{}, keys = all.at("keys");
    for (const auto& [name, binding] : scene_.keys) {
      if (faults.full()) return;
      end_if_asked(stop_);
      const std::string pointer = keys.at(name).pointer();
      if (const auto* position = std::get_if<Vec3d>(&binding)) check(*position, pointer);
      else if (!check(*std::get<SharedValue>(binding), pointer)) return;
    }
  }

  Faults faults;

 private:
  static constexpr int most_patches = 100;
  static constexpr std::size_t most_bytes = 16 << 20;
  static constexpr std::int64_t most_bulk = 1 << 27;  // of pixels about a second

  void check(const Vec3d& position, const std::string& pointer) {
    const Light* own = key_light_of(scene_);
    Light light = own != nullptr ? *own : Light{};
    if (!target_) target_ = looked_at(scene_, axis_of(scene_), middles_of(scene_, stop_));
    if (auto fault = put(light, position, *target_, pointer)) faults.add(std::move(*fault));
  }

  // Whether there is room to try it.
  bool check(const Value& patch, const std::string& pointer) {
    MergedParts merged{scene_, *patch.as<Value::Object>()};
    if (++patches_ <= most_patches) Scene::fields(merged);
    bytes_ += to_json(merged.parts).size();
    if (patches_ > most_patches || bytes_ > most_bytes) return too_much();
    Faults found(stop_);
    Scene changed;
    read_value(merge_patch(std::move(merged.parts), patch), Place{}, Spec{}, found, changed);
    if (!found.empty())
      faults.add({FaultKind::conflict, pointer, std::nullopt,
                  "a patch that leaves a scene; after this one " + describe(found.list().front()) +
                      others(found.count())});
    bulk_ += found.taken(Bulk::scanned_pixels) + found.taken(Bulk::cells);
    return bulk_ <= most_bulk || too_much();
  }

  bool too_much() {
    faults.add({FaultKind::limit, "/keys", std::nullopt,
                "at most " + std::to_string(most_patches) + " patches, which merge with at most " +
                    std::to_string(most_bytes) + " bytes of the scene together, and in which " +
                    std::to_string(most_bulk) +
                    " pixels (of a JPEG with every scan) and cells are read"});
    return false;
  }

  const Scene& scene_;
  std::stop_token stop_;
  std::optional<Vec3d> target_;  // of lights that keys put somewhere
  int patches_ = 0;
  std::size_t bytes_ = 0;
  std::int64_t bulk_ = 0;
};

}  // namespace

void check_keys(const Scene& scene, const std::stop_token& stop) {
  if (scene.keys.empty()) return;
  KeyCheck check(scene, stop);
  check();
  check.faults.raise();
}

}  // namespace tia
