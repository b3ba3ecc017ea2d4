#include "core/scene/moments.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "core/scene/animation_fields.h"
#include "core/scene/at_time.h"

namespace tia {
namespace {

// Fields of objects that count with those of other objects (Scene::check_links), or look them up.
constexpr std::array<std::string_view, 5> counted_together{"material", "materials", "repeat",
                                                           "type", "id"};

bool is_number_list(const Value& value) {
  const auto* list = value.as<Value::Array>();
  return list != nullptr &&
         std::ranges::all_of(*list, [](const Value& each) { return each.as<double>() != nullptr; });
}

bool is_of_numbers(const Track& track) {
  if (track.formula) return true;
  return track.keys && std::ranges::all_of(*track.keys, [](const AnimationKey& key) {
           return key.value->as<double>() != nullptr || is_number_list(*key.value);
         });
}

bool moves_apart(const Track& track, const TargetPath& steps) {
  if (steps.empty()) return false;
  for (const std::string_view shared : {"materials", "ambient_light", "key_light"})
    if (steps.front() == shared) return false;
  if (steps.front() != "objects") return true;
  return is_of_numbers(track) && std::ranges::none_of(steps, [](const std::string& step) {
           return std::ranges::find(counted_together, step) != counted_together.end();
         });
}

bool shows_model(const Object& object) {
  if (std::holds_alternative<PlacedModel>(object.shape)) return true;
  const auto* children = children_of(object);
  return children != nullptr && std::ranges::any_of(*children, shows_model);
}

}  // namespace

std::optional<MovingScene> moving_scene(const Scene& scene) {
  const std::vector<Track>& tracks = scene.animation->tracks;
  std::vector<TargetPath> targets;
  for (const Track& track : tracks) {
    targets.push_back(steps_of(track.target));
    if (!moves_apart(track, targets.back())) return std::nullopt;
  }
  const MovedObjects moved = moved_objects(scene.objects, tracks, targets);
  if (!moved) return std::nullopt;
  MovingScene part{scene, {moved->begin(), moved->end()}};
  std::vector<Object> own;
  for (const std::size_t each : part.moved) {
    if (shows_model(scene.objects[each])) return std::nullopt;
    own.push_back(std::as_const(scene.objects)[each]);
  }
  part.scene.objects = std::move(own);
  for (std::size_t i = 0; i < targets.size(); ++i) {
    if (targets[i].front() != "objects") continue;
    const auto at = std::ranges::lower_bound(part.moved, *number_of_step(targets[i][1]));
    targets[i][1] = std::to_string(at - part.moved.begin());
    part.scene.animation->tracks[i].target = pointer_of(targets[i]);
  }
  return part;
}

Moments::Moments(const Scene& scene) : scene_(scene) {
  // One of so many at most: of more that go far, what is fitted anew is slower than a new index.
  constexpr std::size_t few = 64;
  if (!moves_objects(*scene.animation)) return;
  auto part = moving_scene(scene);
  if (!part || part->moved.size() * few > scene.objects.size()) return;
  part_ = std::move(part->scene);
  moved_ = std::move(part->moved);
  all_ = scene.objects;
}

// Faults are told of the whole scene.
Scene Moments::at(double seconds, const Place& at, const std::stop_token& stop) {
  Scene plain = [&] {
    try {
      return at_time(part_, seconds, {}, at, stop);
    } catch (const InputError&) {
      return at_time(scene_, seconds, {}, at, stop);
    }
  }();
  std::vector<Object>& all = all_.edit();
  for (std::size_t i = 0; i < moved_.size(); ++i) all[moved_[i]] = std::move(plain.objects[i]);
  plain.objects = all_;
  return plain;
}

}  // namespace tia
