// What keys, lights and times need to know of a scene: the scene after a patch, which is written,
// patched and read again; the middles of its objects, which may have to be built for that; how its
// bodies move. All are made as long work and kept in bounded memory. Any thread may call.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>

#include "core/motion/simulation.h"
#include "core/scene/keys.h"
#include "server/operation/long_work.h"
#include "server/operation/lru_map.h"
#include "server/operation/memory_account.h"
#include "server/stores/known_scene.h"

namespace tia::server {

class PressedScenes {
 public:
  /// Of 0 bytes it keeps nothing.
  PressedScenes(std::int64_t max_bytes, LongWork& long_work, MemoryAccount& account)
      : share_(max_bytes, &account, MemoryAccount::pressed), long_work_(long_work) {}

  /// The scene `name` after the key; a scene without a name ("") is not kept.
  /// Errors: InputError, as press(); HttpError (busy, too-large); Stopped.
  KnownScene get(const std::string& name, const KnownScene& scene, const std::string& key,
                 const Requester& requester);
  /// The middles of the scene's objects.
  /// Errors: HttpError (busy); Stopped.
  using SharedMiddles = std::shared_ptr<const Middles>;
  SharedMiddles middles_of(const KnownScene& scene, const Requester& requester);
  /// How the bodies of a scene with physics move, in at most so many events.
  /// Errors: as simulate(), at /scene; HttpError (busy, too-large); Stopped.
  using SharedSimulation = std::shared_ptr<const Simulation>;
  SharedSimulation simulation_of(const KnownScene& scene, std::int64_t most_events,
                                 const Requester& requester);
  /// Lets go of those that nobody has asked for longest. Returns: how many bytes.
  std::int64_t give_way(std::int64_t bytes);

 private:
  /// Kept: one of them.
  struct Kept {
    KnownScene scene;
    SharedMiddles middles;
    SharedSimulation simulation;
    std::size_t bytes = 0;
  };
  using All = LruMap<std::string, Kept>;
  Kept find(const std::string& name);
  void keep(const std::string& name, Kept made);
  void take_surplus(std::size_t most, All::Entries& surplus);

  MemoryShare share_;
  LongWork& long_work_;
  std::mutex mutex_;
  All kept_;
  std::size_t bytes_ = 0;
};

}  // namespace tia::server
