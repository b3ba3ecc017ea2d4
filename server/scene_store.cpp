#include "server/scene_store.h"

#include "core/scene/read_scene.h"
#include "server/digest.h"
#include "server/scene_bytes.h"

namespace tia::server {
namespace {

constexpr std::size_t entry_bytes = 352;  // an entry's own, with its place in list and index

}  // namespace

std::string SceneStore::keep(Scene scene) {
  const std::string id = sha256_hex(canonical_text(scene));
  const std::size_t bytes = entry_bytes + bytes_of(scene);
  if (bytes > max_bytes_)
    throw InputError({FaultKind::limit, "",
                      Value("a scene of " + std::to_string(bytes) + " bytes in memory"),
                      "kept scenes of " + std::to_string(max_bytes_) +
                          " bytes in all (option TIA_MAX_SCENES_BYTES)"});
  Entries made, surplus;
  const Digest objects = digest_of_objects(scene).all;
  made.push_back({id, {std::make_shared<const Scene>(std::move(scene)), objects}, bytes});
  const std::lock_guard lock(mutex_);
  if (const auto known = by_id_.find(id); known != by_id_.end()) {
    entries_.splice(entries_.begin(), entries_, known->second);
    return id;
  }
  by_id_.emplace(made.front().id, made.begin());
  entries_.splice(entries_.begin(), made);
  bytes_ += bytes;
  surplus = take_surplus();
  return id;
}

KnownScene SceneStore::find(std::string_view id) {
  const std::lock_guard lock(mutex_);
  const auto known = by_id_.find(id);
  if (known == by_id_.end()) return {};
  entries_.splice(entries_.begin(), entries_, known->second);
  return known->second->scene;
}

std::size_t SceneStore::count() const {
  const std::lock_guard lock(mutex_);
  return entries_.size();
}

std::size_t SceneStore::bytes() const {
  const std::lock_guard lock(mutex_);
  return bytes_;
}

SceneStore::Entries SceneStore::take_surplus() {
  Entries surplus;
  while (bytes_ > max_bytes_ || entries_.size() > max_scenes_) {
    const auto last = std::prev(entries_.end());
    bytes_ -= last->bytes;
    by_id_.erase(last->id);
    surplus.splice(surplus.end(), entries_, last);
  }
  return surplus;
}

}  // namespace tia::server
