#include "server/access/shared_quotas.h"

#include <algorithm>
#include <utility>

#include "server/access/secrets.h"
#include "server/operation/log.h"

namespace tia::server {
namespace {

// Redis' clock tells microseconds, which Lua's numbers hold exactly until the year 2255.
constexpr std::int64_t one_us = 1000;

// The interval, the refill, how long it takes until the bucket is full by what is known here.
// Returns: whether one is taken, how long it takes then. Unit: us.
constexpr const char* take_text = R"lua(
local interval, refill, known = tonumber(ARGV[1]), tonumber(ARGV[2]), tonumber(ARGV[3])
local time = redis.call('TIME')
local now = time[1] * 1000000 + time[2]
local full_at = tonumber(redis.call('GET', KEYS[1]) or 0)
local to_full = math.min(math.max(full_at - now, known, 0), refill)
local is_taken = to_full + interval <= refill
if is_taken then to_full = to_full + interval end
redis.call('SET', KEYS[1], string.format('%.0f', now + to_full), 'PX',
           math.ceil(to_full / 1000) + 1)
return {is_taken and 1 or 0, to_full}
)lua";

// The process, all that it has counted. Returns: what all have.
constexpr const char* count_text = R"lua(
local process, own = ARGV[1], tonumber(ARGV[2])
local more = own - tonumber(redis.call('HGET', KEYS[1], process) or 0)
if more <= 0 then return tonumber(redis.call('HGET', KEYS[1], 'sum') or 0) end
redis.call('HSET', KEYS[1], process, ARGV[2])
redis.call('EXPIRE', KEYS[1], 172800)
return redis.call('HINCRBY', KEYS[1], 'sum', more)
)lua";

RedisOptions with_short_waits(RedisOptions redis) {
  redis.timeout = std::min(redis.timeout, std::chrono::milliseconds(250));
  return redis;
}

std::int64_t us_up(std::int64_t ns) { return (ns + one_us - 1) / one_us; }

}  // namespace

SharedQuotas::SharedQuotas(RedisOptions redis, std::chrono::milliseconds rest)
    : redis_(with_short_waits(std::move(redis))),
      take_(take_text),
      count_(count_text),
      rest_(rest),
      process_(random_secret().substr(0, 16)) {}

bool SharedQuotas::is_asked() const {
  const std::lock_guard lock(mutex_);
  return Clock::now() >= ask_after_;
}

// Returns: whether it has been answered.
template <class Ask>
bool SharedQuotas::ask(const Ask& asks) {
  if (!is_asked()) return false;
  try {
    asks();
    return true;
  } catch (const std::exception& error) {
    log_failure("keys", std::string("each server counts for itself: ") + error.what());
  }
  const std::lock_guard lock(mutex_);
  ask_after_ = Clock::now() + rest_;
  return false;
}

RequestsLeft SharedQuotas::take(const std::string& key, const RequestRate& rate, std::int64_t now) {
  const RequestRate in_us{us_up(rate.interval), rate.burst};
  const auto known = [&] {  // of a bucket that Redis may know less of
    const std::lock_guard lock(mutex_);
    return alone_.contains(key) ? us_up(own_.look(key, rate, now).to_full) : 0;
  }();
  RedisReply reply;
  const bool is_answered = ask([&] {
    reply = take_.run(
        redis_, std::string(farm_prefix) + "requests:" + key,
        {std::to_string(in_us.interval), std::to_string(in_us.refill()), std::to_string(known)});
  });
  if (!is_answered || reply.items.size() != 2) {
    const std::lock_guard lock(mutex_);
    alone_.insert(key);
    return own_.take(key, rate, now);
  }
  {
    const std::lock_guard lock(mutex_);
    alone_.erase(key);
  }
  RequestsLeft left = own_.learn(key, rate, now, reply.items[1].count * one_us);
  left.is_taken = reply.items[0].count == 1;
  return left;
}

RequestsLeft SharedQuotas::look(const std::string& key, const RequestRate& rate, std::int64_t now) {
  return own_.look(key, rate, now);
}

// Domain: the lock is held.
SharedQuotas::Rays& SharedQuotas::rays_of(const std::string& key, std::int64_t day) {
  Rays& rays = rays_[key];
  if (day > rays.day) rays = {.day = day};
  return rays;
}

std::int64_t SharedQuotas::add_rays(const std::string& key, std::int64_t day, std::int64_t rays) {
  const std::int64_t own = [&] {
    const std::lock_guard lock(mutex_);
    return rays_of(key, day).own += rays;
  }();
  RedisReply reply;
  const bool is_answered = ask([&] {
    reply = count_.run(redis_, std::string(farm_prefix) + "rays:" + key + ':' + std::to_string(day),
                       {process_, std::to_string(own)});
  });
  const std::lock_guard lock(mutex_);
  Rays& known = rays_of(key, day);
  if (is_answered && known.day == day && own >= known.told)
    known.told = own, known.sum = reply.count;
  return known.all();
}

std::int64_t SharedQuotas::rays(const std::string& key, std::int64_t day) {
  const std::lock_guard lock(mutex_);
  return rays_of(key, day).all();
}

}  // namespace tia::server
