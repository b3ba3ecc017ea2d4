#include "server/stores/pressed_scenes.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "core/input/json.h"
#include "core/motion/simulate.h"
#include "server/operation/memory_costs.h"
#include "server/stores/digest.h"
#include "server/stores/scene_bytes.h"

namespace tia::server {
namespace {

// All that a motion depends on: the objects with their names, and when they are there.
std::string motion_name(const KnownScene& scene) {
  const Value said = Value::Array{write_value(*scene->physics), write_value(scene->animation)};
  return "motion\n" + hex(scene.objects.digest) + sha256_hex(to_json(said));
}

}  // namespace

KnownScene PressedScenes::get(const std::string& name, const KnownScene& scene,
                              const std::string& key, const Requester& requester) {
  const std::string both = name.empty() ? "" : name + '\n' + key;
  if (KnownScene made = find(both).scene) return made;
  const std::size_t bytes = bytes_of(*scene);
  const std::int64_t memory = memory_for(memory_cost::patch, bytes);
  return long_work_({bytes, memory, "the scene with its key's patch"}, requester, [&] {
    if (KnownScene made = find(both).scene) return made;  // by somebody meanwhile
    KnownScene made =
        known(std::make_shared<const Scene>(press(*scene, key, Middles{}, "/key", requester.stop)));
    if (!both.empty()) keep(both, {made, nullptr, nullptr, bytes_of(*made)});
    return made;
  });
}

PressedScenes::SharedMiddles PressedScenes::middles_of(const KnownScene& scene,
                                                       const Requester& requester) {
  static const auto none = std::make_shared<const Middles>();
  if (scene->camera.look_at || scene->objects.empty()) return none;
  const std::string name = "middles\n" + hex(scene.objects.digest);
  if (SharedMiddles made = find(name).middles) return made;
  return long_work_({scene.objects.bytes, 0, "the scene's objects"}, requester, [&] {
    auto made = std::make_shared<const Middles>(tia::middles_of(*scene, requester.stop));
    keep(name, {{}, made, nullptr, made->capacity() * sizeof(Vec3d)});
    return made;
  });
}

PressedScenes::SharedSimulation PressedScenes::simulation_of(const KnownScene& scene,
                                                             std::int64_t most_events,
                                                             const Requester& requester) {
  const std::string name = motion_name(scene);
  if (SharedSimulation made = find(name).simulation) return made;
  // However short the scene, its motion may take long: that counts as a long text.
  const std::size_t bytes = std::max(scene.objects.bytes, Admission::longest_short_text + 1);
  const std::int64_t memory = memory_for(memory_cost::patch, scene.objects.bytes);
  return long_work_({bytes, memory, "the motion of the scene's bodies"}, requester, [&] {
    if (SharedSimulation made = find(name).simulation) return made;  // by somebody meanwhile
    const Place all{};
    const auto made = std::make_shared<const Simulation>(
        simulate(*scene, static_cast<std::size_t>(most_events), all.at("scene"), requester.stop));
    keep(name, {{}, nullptr, made, bytes_of(*made)});
    return made;
  });
}

PressedScenes::Kept PressedScenes::find(const std::string& name) {
  const std::lock_guard lock(mutex_);
  const Kept* const known = kept_.find(name);
  return known == nullptr ? Kept{} : *known;
}

void PressedScenes::keep(const std::string& name, Kept made) {
  constexpr std::size_t entry_bytes = 512;  // an entry's own, with its places in list and table
  const std::size_t bytes = made.bytes += entry_bytes;
  All::Entries surplus;
  const std::lock_guard lock(mutex_);
  const std::size_t most = share_.most();
  if (bytes > most || kept_.contains(name)) return;
  kept_.add(name, std::move(made));
  bytes_ += bytes;
  take_surplus(most, surplus);
}

void PressedScenes::take_surplus(std::size_t most, All::Entries& surplus) {
  while (bytes_ > most) {
    bytes_ -= kept_.last().bytes;
    kept_.take_last(surplus);
  }
  share_.book(bytes_);
}

std::int64_t PressedScenes::give_way(std::int64_t bytes) {
  All::Entries surplus;
  const std::lock_guard lock(mutex_);
  const std::size_t before = bytes_, less = static_cast<std::size_t>(bytes);
  take_surplus(before > less ? before - less : 0, surplus);
  return static_cast<std::int64_t>(before - bytes_);
}

}  // namespace tia::server
