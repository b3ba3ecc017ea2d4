#include "server/scene_store.h"

#include <limits>

#include "core/scene/read_scene.h"
#include "server/digest.h"
#include "server/scene_bytes.h"

namespace tia::server {
namespace {

constexpr std::size_t scene_entry_bytes = 416;  // an entry's own, with its places in list and table

}  // namespace

std::string SceneStore::keep(Scene scene) {
  const std::string text = canonical_text(scene), id = sha256_hex(text);
  const std::size_t bytes = scene_entry_bytes + bytes_of(scene);
  if (!file_ && bytes > max_bytes_)
    throw InputError({FaultKind::limit, "",
                      Value("a scene of " + std::to_string(bytes) + " bytes in memory"),
                      "kept scenes of " + std::to_string(max_bytes_) +
                          " bytes in all (option TIA_MAX_SCENES_BYTES)"});
  if (known(id)) return id;
  if (file_) file_->keep(id, text);
  remember(id, std::move(scene));
  return id;
}

KnownScene SceneStore::find(const std::string& id) {
  if (KnownScene scene = known(id)) return scene;
  if (!file_ || id.size() != 2 * Digest{}.size()) return {};
  const auto text = file_->find(id);
  if (!text) return {};
  constexpr JsonLimits any{.values = std::numeric_limits<std::size_t>::max()};
  return remember(id, read_described<Scene>(parse_json(*text, any)));  // it was checked when kept
}

KnownScene SceneStore::known(const std::string& id) {
  const std::lock_guard lock(mutex_);
  const Kept* const kept = scenes_.find(id);
  return kept == nullptr ? KnownScene{} : kept->scene;
}

// Where it fits into memory it stays there.
KnownScene SceneStore::remember(const std::string& id, Scene scene) {
  const std::size_t bytes = scene_entry_bytes + bytes_of(scene);
  const ObjectsName objects = digest_of_objects(scene).all;
  Kept kept{{std::make_shared<const Scene>(std::move(scene)), objects}, bytes};
  const KnownScene made = kept.scene;
  Scenes::Entries surplus;
  const std::lock_guard lock(mutex_);
  if (bytes > max_bytes_ || scenes_.find(id) != nullptr) return made;
  scenes_.add(id, std::move(kept));
  bytes_ += bytes;
  surplus = take_surplus();
  return made;
}

std::size_t SceneStore::count() const {
  const std::lock_guard lock(mutex_);
  return scenes_.size();
}

std::size_t SceneStore::bytes() const {
  const std::lock_guard lock(mutex_);
  return bytes_;
}

SceneStore::Scenes::Entries SceneStore::take_surplus() {
  Scenes::Entries surplus;
  while (bytes_ > max_bytes_ || scenes_.size() > max_scenes_) {
    bytes_ -= scenes_.last().bytes;
    scenes_.take_last(surplus);
  }
  return surplus;
}

}  // namespace tia::server
