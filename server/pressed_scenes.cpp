#include "server/pressed_scenes.h"

#include <memory>
#include <utility>

#include "core/scene/keys.h"
#include "server/operation/memory_costs.h"
#include "server/scene_bytes.h"

namespace tia::server {

KnownScene PressedScenes::get(const std::string& name, const KnownScene& scene,
                              const std::string& key, const std::string& client,
                              const std::stop_token& stop) {
  const std::string both = name.empty() ? "" : name + '\n' + key;
  if (KnownScene known = find(both)) return known;
  const std::size_t bytes = bytes_of(*scene);
  const auto ticket = admission_.read(bytes, client, stop);
  if (KnownScene known = find(both)) return known;  // somebody has made it meanwhile
  reserve_memory(memory_for(memory_cost::patch, bytes), "the scene with its key's patch", stop);
  Scene pressed = press(*scene, key);
  const ObjectsName objects = digest_of_objects(pressed).all;
  const KnownScene made{std::make_shared<const Scene>(std::move(pressed)), objects};
  if (!both.empty()) keep(both, made);
  settle_memory();
  return made;
}

KnownScene PressedScenes::find(const std::string& name) {
  const std::lock_guard lock(mutex_);
  const Kept* const known = scenes_.find(name);
  return known == nullptr ? KnownScene{} : known->scene;
}

void PressedScenes::keep(const std::string& name, const KnownScene& scene) {
  constexpr std::size_t entry_bytes = 512;  // an entry's own, with its places in list and table
  const std::size_t bytes = entry_bytes + bytes_of(*scene);
  Scenes::Entries surplus;
  const std::lock_guard lock(mutex_);
  const std::size_t most = share_.most();
  if (bytes > most || scenes_.contains(name)) return;
  scenes_.add(name, {scene, bytes});
  bytes_ += bytes;
  take_surplus(most, surplus);
}

void PressedScenes::take_surplus(std::size_t most, Scenes::Entries& surplus) {
  while (bytes_ > most) {
    bytes_ -= scenes_.last().bytes;
    scenes_.take_last(surplus);
  }
  share_.book(bytes_);
}

std::int64_t PressedScenes::give_way(std::int64_t bytes) {
  Scenes::Entries surplus;
  const std::lock_guard lock(mutex_);
  const std::size_t before = bytes_, less = static_cast<std::size_t>(bytes);
  take_surplus(before > less ? before - less : 0, surplus);
  return static_cast<std::int64_t>(before - bytes_);
}

}  // namespace tia::server
