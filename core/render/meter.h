// The rays of a whole render, counted while it goes on, and what ends it early.
#pragma once

#include <atomic>
#include <cstdint>
#include <stop_token>
#include <utility>

#include "core/integrators/integrator.h"

namespace tia {

/// RayCounts: exact numbers of rays by kind; a shadow ray for each lamp and hit with n.l > 0.
struct RayCounts {
  std::int64_t primary = 0, shadow = 0, reflection = 0, refraction = 0;
  bool operator==(const RayCounts&) const = default;
};

/// RayMeter: sums what all threads trace.
class RayMeter {
 public:
  /// How many rays a thread may trace before it adds them up.
  static constexpr long often = 1L << 18;
  /// How many tests of boxes and surfaces a whole render may take, in its limit of rays: more than
  /// ordinary scenes take, where rays share theirs in packets.
  static constexpr std::int64_t tests_a_ray = 100;

  RayMeter(std::int64_t max_rays, std::stop_token stop)
      : max_rays_(max_rays), stop_(std::move(stop)) {}
  /// Adds the rays and sets them to none. Errors: InputError once the sum passes the limit, which
  /// no order of threads changes.
  void add(RayTally& rays);
  /// Adds them where they have become many. Errors: also Stopped, if that is asked for.
  void add_if_many(RayTally& rays) {
    if (rays.primary + rays.shadow >= often) add_many(rays);
  }
  RayCounts counts() const { return {.primary = primary_, .shadow = shadow_}; }

 private:
  void add_many(RayTally& rays);

  std::int64_t max_rays_;
  std::stop_token stop_;
  std::atomic<std::int64_t> all_ = 0, primary_ = 0, shadow_ = 0, tests_ = 0;
};

}  // namespace tia
