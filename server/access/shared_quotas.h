// Quotas that several servers count together in their farm's Redis.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <mutex>
#include <set>
#include <string>

#include "server/access/quotas.h"
#include "server/stores/redis.h"

namespace tia::server {

/// SharedQuotas: one script a check, which Redis does as one change. While Redis is away each
/// process counts for itself from what it last knew, and asks again after a second.
///
/// Requests: `{tia}:1:requests:KEY` is the time at which the bucket is full again, by Redis' clock.
/// Rays: `{tia}:1:rays:KEY:DAY` has a field of what each process has counted, and `sum`. A process
/// tells its own count whole, not what has come to it, so that it may tell it twice, and tells with
/// the next one what it has counted alone. Source: Shapiro et al., "Conflict-free replicated data
/// types" (2011), 3.1.1 (a counter that grows).
class SharedQuotas final : public Quotas {
 public:
  using Clock = std::chrono::steady_clock;

  /// Asks for nothing yet; and for so long after Redis has not answered.
  explicit SharedQuotas(RedisOptions redis,
                        std::chrono::milliseconds rest = std::chrono::seconds(1));

  RequestsLeft take(const std::string& key, const RequestRate& rate, std::int64_t now) override;
  RequestsLeft look(const std::string& key, const RequestRate& rate, std::int64_t now) override;
  std::int64_t add_rays(const std::string& key, std::int64_t day, std::int64_t rays) override;
  std::int64_t rays(const std::string& key, std::int64_t day) override;
  bool may_wait() const override { return true; }

 private:
  /// Rays: of a key on its latest day. `sum` is what all had counted when this process had told
  /// them `told` of its `own`.
  struct Rays {
    std::int64_t day = 0, own = 0, told = 0, sum = 0;
    std::int64_t all() const { return sum + own - told; }
  };

  bool is_asked() const;
  template <class Ask>
  bool ask(const Ask& asks);
  Rays& rays_of(const std::string& key, std::int64_t day);

  Redis redis_;
  RedisScript take_, count_;
  const std::chrono::milliseconds rest_;
  const std::string process_;  // what it is called in Redis
  OwnQuotas own_;              // as far as it is known here
  mutable std::mutex mutex_;
  std::map<std::string, Rays> rays_;
  std::set<std::string> alone_;  // keys whose requests were last counted here
  Clock::time_point ask_after_{};
};

}  // namespace tia::server
