// Scenes that clients have sent to be kept, by id, in bounded memory and, if that is wanted, in a
// file that outlives the server. Any thread may call.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "server/operation/long_work.h"
#include "server/operation/lru_map.h"
#include "server/operation/memory_account.h"
#include "server/stores/known_scene.h"
#include "server/stores/scene_file.h"

namespace tia::server {

/// NewScene: one with all that is kept of it. It goes through the whole scene.
struct NewScene {
  NewScene(Scene scene);
  std::string text, id;  ///< canonical, and its SHA-256
  KnownScene scene;
  std::size_t bytes = 0;  ///< in memory
};

class SceneStore {
 public:
  static constexpr std::size_t most_scenes = 10'000;
  /// Seconds of Unix.
  using Now = std::function<std::int64_t()>;
  static std::int64_t system_now();

  explicit SceneStore(std::int64_t max_bytes, std::size_t max_scenes = most_scenes)
      : max_bytes_(static_cast<std::size_t>(max_bytes)), max_scenes_(max_scenes) {}
  /// With a file, memory holds those of its scenes that are in use.
  SceneStore(std::int64_t max_bytes, std::unique_ptr<SceneFile> file) : SceneStore(max_bytes) {
    file_ = std::move(file);
  }
  /// From now on scenes that nobody has used for so long are forgotten; 0: none are.
  void forget_after(std::int64_t seconds, Now now = system_now);
  /// Books what memory they take.
  void book_with(MemoryAccount& account) {
    share_ = std::make_unique<MemoryShare>(static_cast<std::int64_t>(max_bytes_), &account,
                                           MemoryAccount::scenes);
  }

  /// Keeps a scene, in the file where there is one; else it lets go of those that nobody has asked
  /// for longest, until all fit: of the owner's client's where that has half of the memory.
  /// Returns: its id, the SHA-256 of its canonical text.
  /// Errors: InputError (limit) for a scene that does not fit alone; as SceneFile::keep.
  std::string keep(const NewScene& made, Owner owner = {});
  /// From now on scenes are read from the file as long work, and have at most so many JSON values.
  void read_as(LongWork& long_work, std::size_t most_values) {
    long_work_ = &long_work;
    most_values_ = most_values;
  }
  /// The scene of that id, which is the one last asked for from now on; or null.
  /// Errors: as SceneFile::find; HttpError (busy, too-large), Stopped.
  KnownScene find(const std::string& id, const Requester& requester = {});
  /// The same, where it is in memory. Errors: as SceneFile::touch.
  KnownScene in_memory(const std::string& id);
  /// Whether it is in memory, and its use need not be told to the file, which may take long.
  bool is_at_hand(const std::string& id);
  /// Takes the owner of that key off the scene, which goes with its last one. Other processes that
  /// share the file know it as long as it is in their memory. Errors: as SceneFile::remove.
  Removal remove(const std::string& id, const std::string& key_hash);

  /// Whether the scene is there and can be deleted with that key.
  bool knows_owner(const std::string& id, const std::string& key_hash);

  std::size_t count() const;
  /// What all kept scenes hold in memory.
  std::size_t bytes() const;
  /// What the file holds; 0 without one.
  std::int64_t file_bytes() const { return file_ ? file_->bytes() : 0; }

 private:
  struct Kept {
    KnownScene scene;
    std::size_t bytes = 0;
    Owner first{};                        // who kept it first; of a file's nobody
    std::vector<std::string> key_hashes;  // of those who may delete it, without a file
    std::int64_t used_s = 0, told_s = 0;  // when it was used, and when the file was told
  };
  using Scenes = LruMap<std::string, Kept>;
  KnownScene read(const std::string& id, const std::string& text, const std::stop_token& stop);
  // So many bytes of memory.
  KnownScene remember(const std::string& id, const KnownScene& scene, std::size_t bytes,
                      const Owner& owner);
  void put(const std::string& id, const KnownScene& scene, std::size_t bytes, const Owner& owner);
  void take(const std::string& id, Scenes::Entries& into);
  void take_unused(Scenes::Entries& into);
  // Takes out what is too much: of the client's own first.
  void take_surplus(const std::string& client, Scenes::Entries& into);
  bool is_unused(const Kept& kept) const { return keep_s_ > 0 && kept.used_s < now_() - keep_s_; }
  // That it is used now. Returns: whether the file has to be told.
  bool use(Kept& kept) const;

  std::unique_ptr<SceneFile> file_;  // null: they are kept in memory only
  const std::size_t max_bytes_, max_scenes_;
  mutable std::mutex mutex_;
  Scenes scenes_;  // by id
  std::size_t bytes_ = 0;
  std::int64_t keep_s_ = 0;  // 0: for ever
  Now now_ = system_now;
  std::unique_ptr<MemoryShare> share_;
  LongWork* long_work_ = nullptr;
  std::size_t most_values_ = 0;
};

}  // namespace tia::server
