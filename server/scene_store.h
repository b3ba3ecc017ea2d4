// Scenes that clients have sent to be kept, by id, in bounded memory. Any thread may call.
#pragma once

#include <cstdint>
#include <mutex>
#include <string>

#include "server/recent.h"
#include "server/scene_digest.h"

namespace tia::server {

class SceneStore {
 public:
  static constexpr std::size_t most_scenes = 10'000;

  explicit SceneStore(std::int64_t max_bytes, std::size_t max_scenes = most_scenes)
      : max_bytes_(static_cast<std::size_t>(max_bytes)), max_scenes_(max_scenes) {}

  /// Keeps a scene and lets go of those that nobody has asked for longest, until all fit.
  /// Returns: its id, the SHA-256 of its canonical text.
  /// Errors: InputError (limit) for a scene that does not fit alone.
  std::string keep(Scene scene);
  /// The scene of that id, which is the one last asked for from now on; or null.
  KnownScene find(const std::string& id);

  std::size_t count() const;
  /// What all kept scenes hold in memory.
  std::size_t bytes() const;

 private:
  struct Kept {
    KnownScene scene;
    std::size_t bytes = 0;
  };
  using Scenes = Recent<std::string, Kept>;
  // Takes out what is too much.
  Scenes::Entries take_surplus();

  const std::size_t max_bytes_, max_scenes_;
  mutable std::mutex mutex_;
  Scenes scenes_;  // by id
  std::size_t bytes_ = 0;
};

}  // namespace tia::server
