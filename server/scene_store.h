// Scenes that clients have sent to be kept, by id, in bounded memory and, if that is wanted, in a
// file that outlives the server. Any thread may call.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>

#include "server/recent.h"
#include "server/scene_digest.h"
#include "server/scene_file.h"

namespace tia::server {

class SceneStore {
 public:
  static constexpr std::size_t most_scenes = 10'000;

  explicit SceneStore(std::int64_t max_bytes, std::size_t max_scenes = most_scenes)
      : max_bytes_(static_cast<std::size_t>(max_bytes)), max_scenes_(max_scenes) {}
  /// With a file, memory holds those of its scenes that are in use.
  SceneStore(std::int64_t max_bytes, std::unique_ptr<SceneFile> file) : SceneStore(max_bytes) {
    file_ = std::move(file);
  }

  /// Keeps a scene, in the file where there is one; else it lets go of those that nobody has asked
  /// for longest, until all fit.
  /// Returns: its id, the SHA-256 of its canonical text.
  /// Errors: InputError (limit) for a scene that does not fit alone; as SceneFile::keep.
  std::string keep(Scene scene);
  /// The scene of that id, which is the one last asked for from now on; or null.
  /// Errors: as SceneFile::find.
  KnownScene find(const std::string& id);

  std::size_t count() const;
  /// What all kept scenes hold in memory.
  std::size_t bytes() const;
  /// What the file holds; 0 without one.
  std::int64_t file_bytes() const { return file_ ? file_->bytes() : 0; }

 private:
  struct Kept {
    KnownScene scene;
    std::size_t bytes = 0;
  };
  using Scenes = Recent<std::string, Kept>;
  KnownScene known(const std::string& id);
  KnownScene remember(const std::string& id, Scene scene);
  // Takes out what is too much.
  Scenes::Entries take_surplus();

  std::unique_ptr<SceneFile> file_;  // null: they are kept in memory only
  const std::size_t max_bytes_, max_scenes_;
  mutable std::mutex mutex_;
  Scenes scenes_;  // by id
  std::size_t bytes_ = 0;
};

}  // namespace tia::server
