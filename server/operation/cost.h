// What work is expected to take, and from where on it is heavy.
#pragma once

#include <cstdint>

namespace tia::server {

/// Cost: what work is expected to take of all threads together.
struct Cost {
  double seconds = 0;
  bool is_known = false;  ///< a picture of its scene has been drawn

  /// What a ray takes in an ordinary scene. Unit: s of one thread.
  static constexpr double usual_ray = 0.25e-6;
  /// Rays beyond which work is heavy, about seven ordinary pictures', and the seconds of threads
  /// that so many are foreseen to take.
  static constexpr std::int64_t most_light_rays = 1 << 21;
  static constexpr double most_light_seconds = usual_ray * most_light_rays;

  bool is_heavy() const { return seconds > most_light_seconds; }
};

}  // namespace tia::server
