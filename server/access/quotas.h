// How much each key has asked for: a few numbers behind an interface, so that several servers may
// count together elsewhere.
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <string>

namespace tia::server {

/// RequestRate: so many requests at once, and one more each interval. Unit: ns since 1970 in times,
/// ns in intervals.
struct RequestRate {
  std::int64_t interval = 1, burst = 1;

  /// Not more than so many a second.
  static RequestRate of(double requests_per_s, std::int64_t burst);
  /// How long it takes until the burst is there again.
  std::int64_t refill() const { return interval * burst; }
};

/// RequestsLeft: what a rate allows now.
struct RequestsLeft {
  bool is_taken = false;     ///< whether the request that asked may go on
  std::int64_t left = 0;     ///< how many more may follow at once
  std::int64_t wait = 0;     ///< until the next one may; 0 where it may now
  std::int64_t to_full = 0;  ///< until the burst is there again
};

/// Quotas: any thread may call; times do not go back, or little.
class Quotas {
 public:
  virtual ~Quotas() = default;
  /// Takes one request where the rate allows it.
  virtual RequestsLeft take(const std::string& key, const RequestRate& rate, std::int64_t now) = 0;
  /// The same, and takes none.
  virtual RequestsLeft look(const std::string& key, const RequestRate& rate, std::int64_t now) = 0;
  /// Counts rays that have been traced for the key on that day, and tells the day's sum.
  virtual std::int64_t add_rays(const std::string& key, std::int64_t day, std::int64_t rays) = 0;
  /// That sum as it was last told, or known here. As look(), it asks nobody.
  virtual std::int64_t rays(const std::string& key, std::int64_t day) = 0;
  /// Whether the others may have to wait for another machine.
  virtual bool may_wait() const { return false; }
};

/// OwnQuotas: counted in this process, and forgotten with it. However requests come, in t seconds
/// no more than t rate + burst are taken: the bucket is one number, the time at which it would be
/// full again, in whole ns.
/// Source: ITU-T I.371 (2004), annex A, generic cell rate algorithm (virtual scheduling), which
/// tells the same cells apart as a bucket of tokens.
class OwnQuotas final : public Quotas {
 public:
  RequestsLeft take(const std::string& key, const RequestRate& rate, std::int64_t now) override;
  RequestsLeft look(const std::string& key, const RequestRate& rate, std::int64_t now) override;
  std::int64_t add_rays(const std::string& key, std::int64_t day, std::int64_t rays) override;
  std::int64_t rays(const std::string& key, std::int64_t day) override {
    return add_rays(key, day, 0);
  }
  /// That the bucket will be full in so long, as another one knows. Unit: ns.
  RequestsLeft learn(const std::string& key, const RequestRate& rate, std::int64_t now,
                     std::int64_t to_full);

 private:
  struct Count {
    std::int64_t full_at = 0;
    std::int64_t day = 0, rays = 0;
  };

  std::mutex mutex_;
  std::map<std::string, Count> counts_;  // of keys that there are: a file's
};

}  // namespace tia::server
