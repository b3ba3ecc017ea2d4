// What scenes cost: learned from the pictures that were drawn of them, so that a scene whose rays
// multiply unseen is foreseen the next time. Any thread may call.
#pragma once

#include <cstdint>
#include <mutex>
#include <optional>
#include <string>

#include "server/operation/cost.h"
#include "server/operation/lru_map.h"

namespace tia::server {

/// CostMemory: seconds of a thread per ray from the eye, by what the rays meet and how they are
/// traced. Of scenes that it does not know it expects what those that were new have shown lately.
class CostMemory {
 public:
  static constexpr std::size_t most_scenes = 4096;

  /// Of so many rays from the eye into that scene.
  Cost of(const std::string& scene, double rays);
  /// So many of `rays` rays took so many seconds of threads, be it that they were all or that they
  /// were given up: then it is more than that. Errors: std::bad_alloc.
  void learn(const std::string& scene, double rays, double seconds, bool is_whole);

 private:
  std::mutex mutex_;
  LruMap<std::string, double> per_ray_;
  double share_heavy_ = 0;    // of the scenes that were new lately, a moving mean
  double heavy_seconds_ = 1;  // what such a one took
};

}  // namespace tia::server
