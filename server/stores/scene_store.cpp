#include "server/stores/scene_store.h"

#include <algorithm>
#include <chrono>
#include <limits>

#include "core/scene/read_scene.h"
#include "server/operation/memory_costs.h"
#include "server/stores/digest.h"
#include "server/stores/scene_bytes.h"

namespace tia::server {
namespace {

constexpr std::size_t scene_entry_bytes = 640;  // an entry's own, with its places in list and table
constexpr std::size_t owner_bytes = 128;        // the hash of a key to delete it
constexpr std::int64_t most_told_s = 60;        // after which the file is told of a use again

}  // namespace

std::int64_t SceneStore::system_now() {
  using namespace std::chrono;
  return duration_cast<seconds>(system_clock::now().time_since_epoch()).count();
}

void SceneStore::forget_after(std::int64_t seconds, Now now) {
  keep_s_ = seconds;
  now_ = std::move(now);
  if (file_ && keep_s_ > 0) file_->forget_unused_since(now_() - keep_s_);
}

NewScene::NewScene(Scene is)
    : text(canonical_text(is)),
      id(sha256_hex(text)),
      scene(known(std::make_shared<const Scene>(std::move(is)))),
      bytes(scene_entry_bytes + bytes_of(*scene)) {}

std::string SceneStore::keep(const NewScene& made, Owner owner) {
  if (!file_ && made.bytes > max_bytes_)
    throw InputError({FaultKind::limit, "",
                      Value("a scene of " + std::to_string(made.bytes) + " bytes in memory"),
                      "kept scenes of " + std::to_string(max_bytes_) +
                          " bytes in all (option TIA_MAX_SCENES_BYTES)"});
  owner.time_s = now_();
  if (file_ && keep_s_ > 0) file_->forget_unused_since(now_() - keep_s_);
  if (file_) file_->keep(made.id, made.text, owner);
  remember(made.id, made.scene, made.bytes, owner);
  return made.id;
}

KnownScene SceneStore::find(const std::string& id, const Requester& requester) {
  if (KnownScene scene = in_memory(id)) return scene;
  if (!file_ || id.size() != 2 * Digest{}.size()) return {};
  if (keep_s_ > 0) file_->forget_unused_since(now_() - keep_s_);
  const auto text = file_->find(id);
  if (!text) return {};
  if (keep_s_ > 0) file_->touch(id, now_());
  const auto read_it = [&] { return read(id, *text, requester.stop); };
  if (long_work_ == nullptr) return read_it();
  const std::int64_t memory = memory_for_text(text->size(), most_values_);
  return (*long_work_)({text->size(), memory, "the kept scene"}, requester, read_it);
}

KnownScene SceneStore::read(const std::string& id, const std::string& text,
                            const std::stop_token& stop) {
  if (KnownScene scene = in_memory(id)) return scene;  // somebody has read it meanwhile
  constexpr JsonLimits any{.values = std::numeric_limits<std::size_t>::max()};
  // It has been checked when it was kept.
  const KnownScene scene = known(
      std::make_shared<const Scene>(read_described<Scene>(parse_json(text, any, stop), {}, stop)));
  return remember(id, scene, scene_entry_bytes + bytes_of(*scene), {});
}

// The file is told without the lock: it may have to wait for other processes.
KnownScene SceneStore::in_memory(const std::string& id) {
  Scenes::Entries unused;
  std::unique_lock lock(mutex_);
  take_unused(unused);
  Kept* const kept = scenes_.find(id);
  if (kept == nullptr) return {};
  if (is_unused(*kept)) {
    take(id, unused);
    return {};
  }
  const bool must_tell = use(*kept);
  if (must_tell) kept->told_s = kept->used_s;
  const KnownScene scene = kept->scene;
  lock.unlock();
  if (must_tell) file_->touch(id, now_());
  return scene;
}

bool SceneStore::is_at_hand(const std::string& id) {
  const std::lock_guard lock(mutex_);
  Kept* const kept = scenes_.find(id);
  return kept != nullptr && !is_unused(*kept) && !use(*kept);
}

bool SceneStore::use(Kept& kept) const {
  kept.used_s = now_();
  return file_ && keep_s_ > 0 && kept.used_s - kept.told_s >= std::min(most_told_s, keep_s_ / 4);
}

Removal SceneStore::remove(const std::string& id, const std::string& key_hash) {
  if (file_) {
    const Removal removal = file_->remove(id, key_hash);
    if (removal != Removal::done || file_->contains(id)) return removal;
  }
  Scenes::Entries gone;
  const std::lock_guard lock(mutex_);
  Kept* const kept = scenes_.find(id);
  if (kept == nullptr) return file_ ? Removal::done : Removal::unknown;
  if (!file_ && std::erase(kept->key_hashes, key_hash) == 0) return Removal::forbidden;
  if (file_ || kept->key_hashes.empty()) take(id, gone);
  return Removal::done;
}

// Where it fits into memory it stays there: unless the file has lost it meanwhile, for who takes it
// out of the file looks into memory after that.
KnownScene SceneStore::remember(const std::string& id, const KnownScene& scene, std::size_t bytes,
                                const Owner& owner) {
  put(id, scene, bytes, owner);
  if (!file_ || file_->contains(id)) return scene;
  Scenes::Entries gone;
  const std::lock_guard lock(mutex_);
  take(id, gone);
  return scene;
}

void SceneStore::put(const std::string& id, const KnownScene& scene, std::size_t bytes,
                     const Owner& owner) {
  Kept kept{scene, bytes, owner, {}, now_(), 0};
  Scenes::Entries surplus;
  const std::lock_guard lock(mutex_);
  take_unused(surplus);
  if (bytes > max_bytes_) return;
  if (!scenes_.contains(id)) {
    scenes_.add(id, std::move(kept));
    bytes_ += bytes;
  }
  Kept& entry = *scenes_.find(id);
  entry.used_s = now_();
  if (!owner.key_hash.empty() && entry.key_hashes.size() < most_owners) {
    entry.key_hashes.push_back(owner.key_hash);
    entry.bytes += owner_bytes;
    bytes_ += owner_bytes;
  }
  take_surplus(owner.client, surplus);
}

bool SceneStore::knows_owner(const std::string& id, const std::string& key_hash) {
  if (file_) return file_->knows_owner(id, key_hash);
  const std::lock_guard lock(mutex_);
  const Kept* const kept = scenes_.find(id);
  return kept != nullptr && std::ranges::count(kept->key_hashes, key_hash) > 0;
}

std::size_t SceneStore::count() const {
  const std::lock_guard lock(mutex_);
  return scenes_.size();
}

std::size_t SceneStore::bytes() const {
  const std::lock_guard lock(mutex_);
  return bytes_;
}

void SceneStore::take(const std::string& id, Scenes::Entries& into) {
  if (!scenes_.take(id, into)) return;
  bytes_ -= into.back().value.bytes;
  if (share_) share_->book(bytes_);
}

// They stand in the order of their use.
void SceneStore::take_unused(Scenes::Entries& into) {
  while (scenes_.size() > 0 && is_unused(scenes_.last()))
    take(std::string(scenes_.last_key()), into);
}

void SceneStore::take_surplus(const std::string& client, Scenes::Entries& into) {
  const auto is_own = [&](const Kept& kept) { return kept.first.client == client; };
  std::size_t own = 0, own_bytes = 0;
  const bool is_full = bytes_ > max_bytes_ || scenes_.size() > max_scenes_;
  if (is_full && !client.empty())
    scenes_.last_of([&](const Kept& kept) {
      own += is_own(kept) ? 1 : 0;
      own_bytes += is_own(kept) ? kept.bytes : 0;
      return false;
    });
  while (bytes_ > max_bytes_ || scenes_.size() > max_scenes_) {
    const bool has_half = 2 * own_bytes > max_bytes_ || 2 * own > max_scenes_;
    const std::string* const last = has_half ? scenes_.last_of(is_own) : nullptr;
    take(std::string(last != nullptr ? *last : scenes_.last_key()), into);
    if (!is_own(into.back().value)) continue;
    --own;
    own_bytes -= into.back().value.bytes;
  }
  if (share_) share_->book(bytes_);
}

}  // namespace tia::server
