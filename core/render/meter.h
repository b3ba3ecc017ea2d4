// The rays of a whole render, counted while it goes on, and what ends it early.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <stop_token>
#include <utility>

#include "core/integrators/world_view.h"

namespace tia {

/// Told now and then, by any thread, how many rays and tests of them (WorkCounter) a render has
/// taken so far; may throw, which ends the render.
using Spent = std::function<void(std::int64_t rays, std::int64_t tests)>;

/// RayMeter: sums what all threads trace.
class RayMeter {
 public:
  /// How many rays a thread may trace before it adds them up and lets others go first: some
  /// milliseconds' worth.
  static constexpr long often = 1L << 13;
  RayMeter(std::int64_t max_rays, std::int64_t max_work, std::stop_token stop, Spent spent = {})
      : max_rays_(max_rays),
        max_work_(max_work),
        stop_(std::move(stop)),
        spent_(std::move(spent)) {}
  /// Counts what another render has traced already. Domain: before all else.
  void begin_at(const RayCounts& rays) {
    all_ = rays.all();
    primary_ = rays.primary, shadow_ = rays.shadow;
    reflection_ = rays.reflection, refraction_ = rays.refraction, cut_ = rays.cut;
  }
  /// Adds the rays and sets them to none. Errors: InputError once the sum passes the limit, which
  /// no order of threads changes; what `spent` throws.
  void add(RayCounts& rays);
  /// Adds them where they have become many. Errors: also Stopped, if that is asked for.
  void add_if_many(RayCounts& rays) {
    if (rays.all() >= often) add_many(rays);
  }
  /// Adds a portion of work. Errors: as add()'s; Stopped.
  void add_work(std::int64_t work);
  RayCounts counts() const { return {primary_, shadow_, reflection_, refraction_, cut_}; }

 private:
  void add_many(RayCounts& rays);
  void tell() const {
    if (spent_) spent_(all_, work_);
  }

  std::int64_t max_rays_, max_work_;
  std::stop_token stop_;
  Spent spent_;
  std::atomic<std::int64_t> all_ = 0, work_ = 0;
  std::atomic<std::int64_t> primary_ = 0, shadow_ = 0, reflection_ = 0, refraction_ = 0, cut_ = 0;
};

}  // namespace tia
