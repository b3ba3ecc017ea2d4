#include "server/access/quotas.h"

#include <algorithm>
#include <cmath>

namespace tia::server {
namespace {

// Beyond the refill only a clock that went back can lead: then the bucket counts as empty.
std::int64_t full_at_from(std::int64_t told, const RequestRate& rate, std::int64_t now) {
  return std::clamp(told, now, now + rate.refill());
}

RequestsLeft state_of(std::int64_t full_at, const RequestRate& rate, std::int64_t now) {
  const std::int64_t to_full = full_at - now;
  return {.left = (rate.refill() - to_full) / rate.interval,
          .wait = std::max<std::int64_t>(0, to_full - (rate.refill() - rate.interval)),
          .to_full = to_full};
}

}  // namespace

RequestRate RequestRate::of(double requests_per_s, std::int64_t burst) {
  return {static_cast<std::int64_t>(std::ceil(1e9 / requests_per_s)), burst};
}

RequestsLeft OwnQuotas::take(const std::string& key, const RequestRate& rate, std::int64_t now) {
  const std::lock_guard lock(mutex_);
  std::int64_t& told = counts_[key].full_at;
  const std::int64_t full_at = full_at_from(told, rate, now);
  RequestsLeft state = state_of(full_at, rate, now);
  told = full_at;
  if (state.wait > 0) return state;
  told += rate.interval;
  state = state_of(told, rate, now);
  state.is_taken = true;
  return state;
}

RequestsLeft OwnQuotas::look(const std::string& key, const RequestRate& rate, std::int64_t now) {
  const std::lock_guard lock(mutex_);
  const auto known = counts_.find(key);
  const std::int64_t told = known != counts_.end() ? known->second.full_at : 0;
  return state_of(full_at_from(told, rate, now), rate, now);
}

RequestsLeft OwnQuotas::learn(const std::string& key, const RequestRate& rate, std::int64_t now,
                              std::int64_t to_full) {
  const std::lock_guard lock(mutex_);
  std::int64_t& told = counts_[key].full_at;
  told = full_at_from(now + to_full, rate, now);
  return state_of(told, rate, now);
}

std::int64_t OwnQuotas::add_rays(const std::string& key, std::int64_t day, std::int64_t rays) {
  const std::lock_guard lock(mutex_);
  Count& count = counts_[key];
  if (day > count.day) count.day = day, count.rays = 0;
  return count.rays += rays;
}

}  // namespace tia::server
