#include "server/operation/cost_memory.h"

#include <algorithm>

namespace tia::server {

Cost CostMemory::of(const std::string& scene, double rays) {
  const std::lock_guard lock(mutex_);
  if (const double* known = per_ray_.find(scene)) return {*known * rays, true};
  const double usual = Cost::usual_ray * rays;
  return {share_heavy_ > 0.5 ? std::max(usual, heavy_seconds_) : usual, false};
}

void CostMemory::learn(const std::string& scene, double rays, double seconds, bool is_whole) {
  constexpr double weight = 1.0 / 8;  // of the newest in moving means
  if (rays < 1 || (!is_whole && seconds < Cost::most_light_seconds)) return;
  LruMap<std::string, double>::Entries surplus;
  const std::lock_guard lock(mutex_);
  const bool heavy = Cost{seconds}.is_heavy();
  if (double* known = per_ray_.find(scene)) {
    *known = is_whole ? seconds / rays : std::max(*known, seconds / rays);
    return;
  }
  share_heavy_ += weight * ((heavy ? 1 : 0) - share_heavy_);
  if (heavy) heavy_seconds_ += weight * (seconds - heavy_seconds_);
  per_ray_.add(scene, seconds / rays);
  if (per_ray_.size() > most_scenes) per_ray_.take_last(surplus);
}

}  // namespace tia::server
