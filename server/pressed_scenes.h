// Scenes after a key whose patch changes more than the light: made with a ticket, for it means to
// write the scene, patch it and read it again, and kept in bounded memory. Any thread may call.
#pragma once

#include <cstdint>
#include <mutex>
#include <stop_token>
#include <string>

#include "server/operation/admission.h"
#include "server/operation/memory_account.h"
#include "server/recent.h"
#include "server/scene_digest.h"

namespace tia::server {

class PressedScenes {
 public:
  /// Of 0 bytes it keeps nothing.
  PressedScenes(std::int64_t max_bytes, Admission& admission, MemoryAccount& account)
      : share_(max_bytes, &account, MemoryAccount::scenes), admission_(admission) {}

  /// The scene `name` after the key; a scene without a name ("") is not kept.
  /// Errors: InputError, as press(); HttpError (busy, too-large); Stopped.
  KnownScene get(const std::string& name, const KnownScene& scene, const std::string& key,
                 const std::string& client, const std::stop_token& stop);
  /// Lets go of those that nobody has asked for longest. Returns: how many bytes.
  std::int64_t give_way(std::int64_t bytes);

 private:
  struct Kept {
    KnownScene scene;
    std::size_t bytes = 0;
  };
  using Scenes = Recent<std::string, Kept>;
  KnownScene find(const std::string& name);
  void keep(const std::string& name, const KnownScene& scene);
  void take_surplus(std::size_t most, Scenes::Entries& surplus);

  MemoryShare share_;
  Admission& admission_;
  std::mutex mutex_;
  Scenes scenes_;
  std::size_t bytes_ = 0;
};

}  // namespace tia::server
